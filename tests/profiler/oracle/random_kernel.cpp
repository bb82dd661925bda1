#include "tests/profiler/oracle/random_kernel.hpp"

#include "tests/profiler/oracle/random_statements.hpp"

namespace warpgrain::oracle {
namespace {

constexpr std::uint32_t max_local = 64;

class KernelWriter {
 public:
  explicit KernelWriter(std::uint64_t seed) : dice_(seed), seed_(seed) {}

  RandomKernel write() {
    RandomKernel kernel;
    kernel.seed = seed_;
    kernel.name = fill("k$", {std::to_string(seed_)});
    kernel.shape = shape();
    std::string functions;
    for (auto n = dice_.one_in(2) ? dice_.below(3) : 0; n > 0; --n) functions += function();
    kernel.source = functions + kernel_text(kernel.name);
    return kernel;
  }

 private:
  // Full warps, parts of warps, and all three dimensions.
  profiler::LaunchShape shape() {
    switch (dice_.below(4)) {
      case 0:
        return {{80, 1, 1}, {40, 1, 1}};
      case 1:
        return {{32, 4, 1}, {16, 4, 1}};
      case 2:
        return {{4, 3, 8}, {4, 3, 4}};
      default:
        return {{128, 1, 1}, {64, 1, 1}};
    }
  }

  // What every function has: words and an array of its own.
  FunctionText scope() {
    FunctionText text;
    for (auto n = 3 + dice_.below(4); n > 0; --n) text.words.push_back(fill("v$", {std::to_string(n)}));
    for (auto n = dice_.below(3); n > 0; --n) text.floats.push_back(fill("f$", {std::to_string(n)}));
    text.callable = functions_;
    return text;
  }

  std::string declarations(const FunctionText& text) {
    std::string result;
    for (const std::string& name : text.words)
      result += fill("uint $ = $;\n", {name, dice_.one_of(text.readable)});
    for (const std::string& name : text.floats) result += fill("float $ = 0.0f;\n", {name});
    for (const std::string& name : text.counters) result += fill("int $ = 0;\n", {name});
    return fill("$int fuel = $;\nuint t[4] = {1u, 2u, 3u, 4u};\n", {result, dice_.number_below(12)});
  }

  static std::string sum_of(const FunctionText& text) {
    std::string sum = "t[0] + t[1] * 3u + t[2] * 5u + t[3] * 7u";
    std::uint32_t factor = 11;
    for (const std::string& name : text.words) sum += fill(" + $ * $u", {name, std::to_string(factor += 2)});
    for (const std::string& name : text.floats)
      sum += fill(" + as_uint($) * $u", {name, std::to_string(factor += 2)});
    return sum;
  }

  std::string function() {
    FunctionText text = scope();
    text.readable = {"a", "b"};
    RandomStatements statements(dice_, text, 5);
    RandomStatements::Around around;
    around.depth = 2;
    around.may_return = true;
    const std::string body = statements.sequence(around);
    const std::string name = fill("h$_$", {std::to_string(seed_), std::to_string(functions_.size())});
    functions_.push_back(name);
    return fill(
        "$uint $(uint a, uint b, global const uint* in) {\n$$return $;\n}\n",
        {dice_.one_in(2) ? "__attribute__((noinline)) " : "", name, declarations(text), body, sum_of(text)});
  }

  std::string kernel_text(const std::string& name) {
    FunctionText text = scope();
    text.is_kernel = true;
    text.readable = {"g", "l", "n", "in[g & 63u]", "in[(g * 7u + 3u) & 63u]"};
    // Compilers take most of the time; many small kernels show more than a few large ones.
    RandomStatements statements(dice_, text, dice_.one_in(16) ? 24 : 4 + static_cast<int>(dice_.below(6)));
    RandomStatements::Around around;
    const bool exchanges = dice_.one_in(3);  // between lanes, at barriers
    around.may_return = !exchanges;
    around.may_tangle = !exchanges;  // PoCL's own loops around barriers do not stand it
    std::string body;
    for (auto n = 1 + dice_.below(2); n > 0; --n) {
      body += statements.sequence(around);
      if (exchanges) body += exchange(text, statements, around);
    }
    const std::string shared = fill(
        "uint size = get_local_size(0) * get_local_size(1) * get_local_size(2);\n"
        "local uint shared[$];\nlocal uint totals[2];\n",
        {std::to_string(max_local)});
    return fill(
        "kernel void $(global const uint* in, global uint* out, global uint* sums, uint n) {\n"
        "uint g = (get_global_id(2) * get_global_size(1) + get_global_id(1)) * get_global_size(0) + "
        "get_global_id(0);\n"
        "uint l = (get_local_id(2) * get_local_size(1) + get_local_id(1)) * get_local_size(0) + "
        "get_local_id(0);\n"
        "$out += g * 4u;\n$$out[0] += $;\n}\n",
        {name, exchanges ? shared : "", declarations(text), body, sum_of(text)});
  }

  // All lanes of the work-group come here together.
  std::string exchange(const FunctionText& text, RandomStatements& statements,
                       const RandomStatements::Around& around) {
    const auto word = [&] { return random_word(dice_, text, 1); };
    const auto condition = [&] { return random_condition(dice_, text, 1); };
    const auto variable = [&] { return dice_.one_of(text.words); };
    const std::string barrier = "barrier(CLK_LOCAL_MEM_FENCE);\n";
    switch (dice_.below(3)) {
      case 0:
        return fill("shared[l] = $;\n$if $ $ ^= shared[(l + $u) % size];\n$",
                    {word(), barrier, condition(), variable(), dice_.number_below(16), barrier});
      case 1:
        return fill(
            "if (l < 2u) totals[l] = 0u;\n$if $ atomic_add(&totals[$ & 1u], $);\n$$ += totals[$ & 1u];\n$",
            {barrier, condition(), word(), word(), barrier, variable(), word(), barrier});
      default:
        return fill(
            "for (uint pass = 0u; pass < n + $u; ++pass) {\nshared[l] = $;\n$$ += shared[(l + pass) % "
            "size];\n$$}\n",
            {dice_.number_below(2), word(), barrier, variable(), statements.sequence(around), barrier});
    }
  }

  Dice dice_;
  std::uint64_t seed_;
  std::vector<std::string> functions_;
};

}  // namespace

RandomKernel random_kernel(std::uint64_t seed) { return KernelWriter(seed).write(); }

}  // namespace warpgrain::oracle
