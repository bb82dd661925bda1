#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "profiler/sass/division_routine.hpp"
#include "tests/profiler/sass/replayed_kernel.hpp"

namespace warpgrain::profiler::sass {
namespace {

struct Division {
  double dividend, divisor;
  DivisionPath path;
};

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

const std::vector<Division> divisions{
    {1, 3, DivisionPath::in_line},
    {-7e100, 2e-100, DivisionPath::in_line},
    {1e-300, 2, DivisionPath::scaled},
    {1, 1e-305 / 4, DivisionPath::in_line},
    {1e-5, 1e-310, DivisionPath::scaled},
    {1, 1e308, DivisionPath::denormal},
    {1e-310, 1, DivisionPath::denormal_exact},
    {no_number, 0, DivisionPath::nan_dividend},
    {1, no_number, DivisionPath::nan_divisor},
    {0, 0, DivisionPath::undefined},
    {infinite, -infinite, DivisionPath::undefined},
    {0, 5, DivisionPath::zero_or_infinite},
    {5, 0, DivisionPath::zero_or_infinite},
    {infinite, 2, DivisionPath::zero_or_infinite},
    {2, infinite, DivisionPath::zero_or_infinite},
};

class DivisionTest : public testing::Test {
 protected:
  DivisionTest() {
    for (std::size_t k = 0; k < 32; ++k) {
      a_.push_back(divisions[k % divisions.size()].dividend);
      b_.push_back(divisions[k % divisions.size()].divisor);
    }
    q_.resize(32);
  }
  std::vector<KernelArgument> arguments() { return {buffer_of(a_), buffer_of(b_), buffer_of(q_)}; }

  const std::string source_ =
      "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n"
      "kernel void k(global const double* a, global const double* b, global double* q) {\n"
      "  const int i = get_global_id(0);\n  q[i] = a[i] / b[i];\n}\n";
  std::vector<double> a_, b_, q_;
};

TEST_F(DivisionTest, RecordsThePathThatItsNumbersTake) {
  const auto executable = compile_kernel(source_, "k", TraceMode::blocks_and_addresses);
  const auto& accesses = executable->graph().blocks[0].accesses;
  const auto path = std::ranges::find_if(accesses, is_path);
  ASSERT_NE(path, accesses.end());
  const auto runner = executable->runner(line_of(32, 32), arguments());
  const std::span<const LaneTrace> lanes = runner->run({0, 0, 0});
  for (std::size_t k = 0; k < divisions.size(); ++k)
    EXPECT_EQ(lanes[k].addresses[path - accesses.begin()], static_cast<std::uint64_t>(divisions[k].path))
        << divisions[k].dividend << " / " << divisions[k].divisor;
}

TEST_F(DivisionTest, CallsTheRoutineForRareNumbersAlone) {
  if (!find_ptxas()) GTEST_SKIP() << no_ptxas;
  const ReplayedKernel r(source_, "k", line_of(32, 32), arguments());
  r.expect_complete();
  EXPECT_EQ(r.nodes(Rule::path), 1U);
  EXPECT_EQ(r.nodes(Rule::routine), division_guards);
  std::uint64_t rare = 0;
  for (std::size_t k = 0; k < 32; ++k)
    rare += divisions[k % divisions.size()].path != DivisionPath::in_line ? 1 : 0;
  EXPECT_EQ(r.lanes_at("RET"), rare);
  EXPECT_EQ(r.lanes_at("EXIT"), 32U);
  EXPECT_EQ(r.warps_at("EXIT"), 1U) << "they come together again";
  EXPECT_EQ(r.replay().fast_paths, 0U);
}

TEST(DivisionRoutine, EachPathGoesItsWay) {
  for (std::size_t guard = 0; guard < division_guards; ++guard)
    EXPECT_FALSE(takes_division_guard(guard, DivisionPath::denormal)) << guard;
  EXPECT_TRUE(takes_division_guard(1, DivisionPath::scaled));
  EXPECT_TRUE(takes_division_guard(2, DivisionPath::denormal_exact));
  for (const DivisionPath path : {DivisionPath::nan_dividend, DivisionPath::nan_divisor,
                                  DivisionPath::undefined, DivisionPath::zero_or_infinite})
    EXPECT_TRUE(takes_division_guard(0, path));
  EXPECT_FALSE(takes_division_guard(5, DivisionPath::zero_or_infinite));
}

TEST(DivisionRoutine, IsNoOtherCode) {
  CodeGraph code;
  code.blocks.resize(2);
  code.blocks[0].next = 1;
  code.blocks[1].end = End::ret;
  EXPECT_FALSE(find_division_guards(code, 0));
}

}  // namespace
}  // namespace warpgrain::profiler::sass
