// One level of a breadth-first search over a graph whose node n has n % 13 edges.
uint edge(uint node, uint k, uint n_nodes) { return (node * 31 + k * k * 97 + 7) % n_nodes; }

kernel void breadth_first_search(global const uint* level, global uint* next_level, global uint* changed,
                                 uint n_nodes, uint depth) {
  const uint node = get_global_id(0);
  if (node >= n_nodes) return;
  if (level[node] % 5 != depth) return;
  const uint n_edges = node % 13;
  for (uint k = 0; k < n_edges; ++k) {
    const uint to = edge(node, k, n_nodes);
    if (level[to] > depth + 2) {
      next_level[to] = depth + 1;
      changed[0] = 1;
    }
  }
}
