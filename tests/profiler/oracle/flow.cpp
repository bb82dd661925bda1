#include "tests/profiler/oracle/flow.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace warpgrain::oracle {
namespace {

using Edges = std::vector<std::vector<Node>>;

Edges reversed(const Edges& edges) {
  Edges result(edges.size());
  for (Node from = 0; from < edges.size(); ++from)
    for (const Node to : edges[from]) result[to].push_back(from);
  return result;
}

}  // namespace

Flow::Flow(const Program& program) {
  cut(program);
  find_loops();
}

void Flow::cut(const Program& program) {
  const auto n = static_cast<Place>(program.steps.size());
  std::set<Place> begins{0};
  for (Place place = 0; place < n; ++place) {
    const Step& step = program.steps[place];
    if (step.kind != Step::Kind::jump && step.kind != Step::Kind::trap) continue;
    begins.insert(place + 1);
    begins.insert(step.to.begin(), step.to.end());
  }
  begins.erase(n);
  std::map<Place, Node> node_at;
  for (const Place place : begins) {
    if (!stretches_.empty()) stretches_.back().last = place;
    node_at[place] = static_cast<Node>(stretches_.size());
    stretches_.push_back({place, n, {}});
  }
  node_at[n] = end();
  for (Stretch& stretch : stretches_)
    for (const Place place : program.steps[stretch.last - 1].to) stretch.to.push_back(node_at.at(place));
}

std::vector<bool> Flow::reached(const std::vector<std::vector<Node>>& edges, Node from,
                                std::optional<Node> without) const {
  std::vector<bool> seen(edges.size());
  if (from == without) return seen;
  std::vector<Node> open{from};
  seen[from] = true;
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    for (const Node to : edges[node])
      if (!seen[to] && to != without) {
        seen[to] = true;
        open.push_back(to);
      }
  }
  return seen;
}

void Flow::find_loops() {
  Edges forward(end() + 1);
  for (Node node = 0; node < end(); ++node) forward[node] = stretches_[node].to;
  const Edges backward = reversed(forward);
  const std::vector<bool> live = reached(forward, 0, std::nullopt);
  for (Node header = 0; header < end(); ++header) {
    const std::vector<bool> around = reached(forward, 0, header);
    Loop loop{header, std::vector<bool>(end()), 0};
    for (const Node tail : backward[header]) {
      if (!live[tail] || around[tail]) continue;  // the header does not dominate it
      const std::vector<bool> leads_there =
          tail == header ? std::vector<bool>(end() + 1) : reached(backward, tail, header);
      for (Node node = 0; node < end(); ++node)
        if (live[node] && (leads_there[node] || node == header)) loop.inside[node] = true;
    }
    loop.size = static_cast<std::size_t>(std::count(loop.inside.begin(), loop.inside.end(), true));
    if (loop.size > 0) loops_.push_back(std::move(loop));
  }
}

std::vector<Node> Flow::nearest_post_dominators(const Loop* level) const {
  Edges forward(end() + 1);
  const auto inside = [&](Node node) { return level == nullptr || level->inside[node]; };
  for (Node node = 0; node < end(); ++node) {
    if (!inside(node)) continue;
    for (const Node to : stretches_[node].to) {
      if (to == (level == nullptr ? end() : level->header)) {
        forward[node].push_back(end());
      } else if (to != end() && inside(to)) {
        forward[node].push_back(to);
      }
    }
  }
  const Edges backward = reversed(forward);
  const std::vector<bool> ends = reached(backward, end(), std::nullopt);
  // [p][n]: n, which can end, cannot without p
  std::vector<std::vector<bool>> needs(end());
  for (Node p = 0; p < end(); ++p) {
    needs[p] = reached(backward, end(), p);
    for (Node node = 0; node < end(); ++node) needs[p][node] = ends[node] && !needs[p][node];
  }
  std::vector<Node> nearest(end(), end());
  for (Node node = 0; node < end(); ++node)
    for (Node p = 0; p < end(); ++p) {
      if (p == node || !needs[p][node]) continue;
      // Of two, the nearer is the one that cannot do without the other.
      if (nearest[node] == end() || needs[nearest[node]][p]) nearest[node] = p;
    }
  return nearest;
}

const Loop* Flow::loop_within(const Loop* level, Node node) const {
  const Loop* outermost = nullptr;
  for (const Loop& loop : loops_) {
    if (&loop == level || !loop.inside[node]) continue;
    if (level != nullptr && (loop.size >= level->size || !level->inside[loop.header])) continue;
    if (outermost == nullptr || loop.size > outermost->size) outermost = &loop;
  }
  return outermost;
}

void Flow::append_level(const Loop* level, std::vector<Node>& order) const {
  const auto node_of = [&](Node node) {
    const Loop* loop = loop_within(level, node);
    return loop == nullptr ? node : loop->header;
  };
  const Node root = node_of(level == nullptr ? 0 : level->header);
  std::map<Node, std::vector<Node>> edges;
  for (Node node = 0; node < end(); ++node) {
    if (level != nullptr && !level->inside[node]) continue;
    for (const Node to : stretches_[node].to) {
      if (to == end() || (level != nullptr && !level->inside[to])) continue;
      edges[node_of(node)].push_back(node_of(to));
    }
  }
  std::set<Node> seen;
  std::vector<Node> post;
  const std::function<void(Node)> visit = [&](Node node) {
    seen.insert(node);
    for (const Node to : edges[node])
      if (!seen.contains(to)) visit(to);
    post.push_back(node);
  };
  visit(root);
  for (auto node = post.rbegin(); node != post.rend(); ++node) {
    const Loop* loop = loop_within(level, *node);
    if (loop == nullptr) {
      order.push_back(*node);
    } else {
      append_level(loop, order);
    }
  }
}

std::vector<Node> Flow::loop_contiguous_order() const {
  std::vector<Node> order;
  append_level(nullptr, order);
  return order;
}

}  // namespace warpgrain::oracle
