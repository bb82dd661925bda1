// Kernels that nobody would write: PTX with lines dropped, doubled, swapped, and operands exchanged. Each is
// refused or runs to an end, and says what is wrong with it.

#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include "core/error.hpp"
#include "tests/profiler/checked_launch.hpp"

namespace warpgrain::profiler {
namespace {

// Between them: private arrays, loops, branches, barriers, local memory, atomics, vectors, divisions.
constexpr const char* sources[] = {
    R"(kernel void k(global int* a, global float4* b, local int* c) {
  int i = get_global_id(0), l = get_local_id(0);
  int mine[16];
  for (int n = 0; n < 16; ++n) mine[n] = a[(i + n) & 63];
  for (int n = 0; n < a[i & 63]; ++n) mine[n & 15] += mine[(n + i) & 15] / (n + 1);
  c[l] = mine[l & 15];
  barrier(CLK_LOCAL_MEM_FENCE);
  if (c[l ^ 1] > 3) atomic_add(a + (i & 63), c[(l + 1) & 31]);
  b[i & 15] = (float4)(sin((float)i), native_sqrt((float)l), b[l & 15].x, 1.0f);
})",
    R"(constant int table[8] = {3, 1, 4, 1, 5, 9, 2, 6};
kernel void k(global int* a, global float4* b, local int* c) {
  int i = get_global_id(0), n = 0, x = a[i & 63];
  while (x > 0 && n < 50) {
    switch (table[x & 7]) {
      case 1: x -= 2; break;
      case 4: x /= 3; continue;
      case 5: x ^= i; break;
      default: x -= table[n & 7];
    }
    ++n;
  }
  global int* p = n & 1 ? a : (global int*)b;
  p[i & 31] = n;
  c[get_local_id(0)] = n;
  for (int step = 16; step > 0; step >>= 1) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) < step) c[get_local_id(0)] += c[get_local_id(0) + step];
  }
  if (get_local_id(0) == 0) a[get_group_id(0)] = c[0] % (n - 3);
})"};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Words and numbers of a line that another may take the place of: registers, labels, immediates.
std::vector<std::pair<std::size_t, std::size_t>> operands_of(const std::string& line) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '%' && line[i] != '$' && !std::isdigit(static_cast<unsigned char>(line[i]))) continue;
    std::size_t end = i + 1;
    while (end < line.size() && is_part(line[end])) ++end;
    if (i == 0 || (!is_part(line[i - 1]) && line[i - 1] != '.')) found.emplace_back(i, end - i);
    i = end;
  }
  return found;
}

std::string mutated(const std::string& ptx, std::mt19937& random) {
  std::vector<std::string> lines = lines_of(ptx);
  std::vector<std::size_t> body;  // instructions and labels
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find(';') != std::string::npos && lines[i].find(".reg") == std::string::npos &&
        lines[i].find(".file") == std::string::npos && lines[i].find(".loc") == std::string::npos)
      body.push_back(i);
  const auto any_line = [&]() -> std::string& { return lines[body[random() % body.size()]]; };
  for (auto n = 1 + random() % 3; n > 0; --n) {
    std::string& line = any_line();
    switch (random() % 6) {
      case 0:
        line.clear();
        break;
      case 1:
        line += any_line();
        break;
      case 2:
        std::swap(line, any_line());
        break;
      default: {
        const auto operands = operands_of(line);
        if (operands.empty()) break;
        const std::string other = any_line();
        const auto choices = operands_of(other);
        const auto [at, size] = operands[random() % operands.size()];
        static constexpr const char* numbers[] = {"0",           "-1", "1",      "2147483647",
                                                  "-2147483648", "13", "1048576"};
        if (choices.empty() || random() % 3 == 0) {
          line.replace(at, size, numbers[random() % std::size(numbers)]);
        } else {
          const auto [from, length] = choices[random() % choices.size()];
          line.replace(at, size, other.substr(from, length));
        }
      }
    }
  }
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

TEST(Mutations, NothingCrashesOrHangs) {
  constexpr int per_kernel = 150;
  int ran = 0, found = 0;
  for (const char* source : sources) {
    const std::string ptx = compile_opencl(source, "kernel.cl", "").ptx;
    for (int seed = 0; seed < per_kernel; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(static_cast<unsigned>(seed));
      const std::string mutation = mutated(ptx, random);
      std::vector<int> a(64, 20);
      std::vector<float> b(64, 1);
      KernelArgument fresh = buffer_of(b);
      fresh.uninitialized = seed % 2 == 0;
      try {
        const auto executable =
            Executable::compile(mutation, "k", TraceMode::blocks_and_addresses, "mutation.ptx", Checks::on);
        const auto counters = run_checked(*executable, line_of(64, 32),
                                          {buffer_of(a), fresh, KernelArgument::local(128)}, 1, 20'000);
        ++ran;
        found += counters.diagnostics.empty() ? 0 : 1;
      } catch (const InputError&) {
      }
    }
  }
  // Neither is everything refused nor everything let pass.
  EXPECT_GT(ran, per_kernel);
  EXPECT_GT(found, per_kernel / 4);
}

}  // namespace
}  // namespace warpgrain::profiler
