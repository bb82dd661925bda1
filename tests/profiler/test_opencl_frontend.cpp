#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/opencl_frontend.hpp"
#include "profiler/subprocess.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;
using testing::Not;

// The line of the source that the first instruction with this text stands in, with its file.
std::string place_of(const KernelGraph& graph, std::string_view text) {
  for (const BasicBlock& block : graph.blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.text.find(text) != std::string::npos)
        return graph.files[instruction.location.file] + ":" + std::to_string(instruction.location.line);
  return "nowhere";
}

TEST(OpenClFrontend, SyntaxErrorsNameFileAndLine) {
  const std::string message =
      refusal([] { compile_opencl("kernel void k(global int* a) {\n  a[0] = ;\n}\n", "dir/broken.cl"); });
  EXPECT_THAT(message, HasSubstr("dir/broken.cl: it does not compile\n"));
  EXPECT_THAT(message, HasSubstr("dir/broken.cl:2:10: error: expected expression"));
  EXPECT_THAT(
      refusal([] { compile_opencl("#line 40 \"laws.cl\"\nkernel void k() { nothing(); }\n", "all.cl"); }),
      HasSubstr("laws.cl:40:"));
  EXPECT_THAT(refusal([] { compile_opencl("#include \"not_there.h\"\n", "a.cl"); }),
              HasSubstr("a.cl:1:10: fatal error: 'not_there.h' file not found"));
}

TEST(OpenClFrontend, BackEndErrorsComeWithoutAStackDump) {
  // NVPTX has no instruction for an exact sine.
  const std::string message = refusal([] {
    compile_opencl(
        "float __attribute__((const)) f(float) __asm(\"llvm.sin.f32\"); kernel void k(global float* a) { "
        "a[0] = f(a[1]); }",
        "a.cl");
  });
  EXPECT_THAT(message, HasSubstr("a.cl: it does not compile\nfatal error: error in backend"));
  EXPECT_THAT(message, Not(HasSubstr("PLEASE")));
}

TEST(OpenClFrontend, NoLabelStandsInACall) {
  const std::string ptx =
      compile_opencl(
          "__attribute__((noinline)) void set(global int* a, int x) { a[x] = x * a[x + 1]; }\n"
          "__attribute__((noinline)) int twice(int x) {\n  return x % 7 == 3 ? x * 2 : x;\n}\n"
          "kernel void k(global int* a) {\n  set(a, twice(a[0]));\n  a[2] = twice(a[1]);\n}\n",
          "a.cl")
          .ptx;
  std::size_t n_calls = 0;
  for (std::size_t at = ptx.find("\tcall"); at != std::string::npos;
       at = ptx.find("\tcall", at + 1), ++n_calls)
    EXPECT_THAT(ptx.substr(at, ptx.find(';', at) - at), Not(HasSubstr("$L__tmp")));
  EXPECT_EQ(n_calls, 3u);
}

TEST(OpenClFrontend, LinesOfTheSourceReachTheGraph) {
  const TemporaryFolder folder;
  write_text(folder.path() / "law.h", "\nfloat law(float x) {\n  return x * 3.0f;\n}\n");
  const std::string name = folder.path() / "kernel.cl";
  const CompiledPtx compiled = compile_opencl(R"(#include "law.h"
kernel void k(global float* a) {
  float x = a[get_global_id(0)];
  float y = law(x);
  float s = native_sin(y);
#line 700 "elsewhere.cl"
  a[get_global_id(0)] = s / x;
})",
                                              name);
  const auto executable = Executable::compile(compiled.ptx, "k", TraceMode::blocks, name);
  const KernelGraph& graph = executable->graph();
  EXPECT_EQ(place_of(graph, "ld.global"), name + ":3");
  EXPECT_EQ(place_of(graph, "mul.rn.f32"), (folder.path() / "law.h").string() + ":3");
  EXPECT_EQ(place_of(graph, "sin.approx"), name + ":5");  // the call, not the prelude
  EXPECT_EQ(place_of(graph, "div.full"), "elsewhere.cl:700");
  for (const std::string& file : graph.files) EXPECT_THAT(file, Not(HasSubstr("prelude")));
}

TEST(OpenClFrontend, RecordsCompilerAndCommand) {
  const CompiledPtx compiled =
      compile_opencl("kernel void k(global int* a) { a[0] = N; }", "a.cl", "-D N=\"3 + 4\"");
  EXPECT_THAT(compiled.compiler, HasSubstr("clang version 15."));
  EXPECT_THAT(compiled.command, HasSubstr("-O2"));
  EXPECT_THAT(compiled.command, HasSubstr("-D N=3 + 4"));
  EXPECT_THAT(compiled.command, Not(HasSubstr("/tmp")));
  EXPECT_THAT(compiled.ptx, HasSubstr(".file\t1 \"./a.cl\""));
}

TEST(OpenClFrontend, ApproximateInstructionsOfTheDefaultAccuracy) {
  const std::string source = R"(kernel void k(global float* a, global double* d, global float4* v) {
  a[0] = sqrt(a[1]) / a[2]; a[3] = rsqrt(a[4]); d[0] = sqrt(d[1]); v[0] = sqrt(v[1]);
  a[5] = native_exp(a[6]) + native_log(a[7]) + native_cos(a[8]) + native_recip(a[9]) + native_powr(a[10], a[11]);
})";
  const std::string ptx = compile_opencl(source, "a.cl").ptx;
  for (const char* instruction : {"sqrt.approx.f32", "div.full.f32", "rsqrt.approx.f32", "sqrt.rn.f64",
                                  "ex2.approx.f32", "lg2.approx.f32", "cos.approx.f32", "rcp.approx.f32"})
    EXPECT_THAT(ptx, HasSubstr(instruction));
  EXPECT_THAT(ptx, Not(HasSubstr("sqrt.rn.f32")));
  const std::string exact = compile_opencl(source, "a.cl", "-cl-fp32-correctly-rounded-divide-sqrt").ptx;
  EXPECT_THAT(exact, HasSubstr("sqrt.rn.f32"));
  EXPECT_THAT(exact, HasSubstr("div.rn.f32"));
}

TEST(OpenClFrontend, TakesTheOptionsOfClBuildProgram) {
  for (const std::string options :
       {"-cl-std=CL1.1", "-cl-std=CL1.2", "-cl-std=CL2.0", "-cl-std=CL3.0", "-cl-fast-relaxed-math",
        "-cl-mad-enable -cl-no-signed-zeros -cl-denorms-are-zero", "-cl-single-precision-constant -w",
        "-cl-opt-disable", "-cl-finite-math-only -cl-unsafe-math-optimizations -cl-strict-aliasing",
        "-D 'A=1 + 2' -DB=\"(3)\" -D C", "-cl-kernel-arg-info -Werror"}) {
    SCOPED_TRACE(options);
    const std::string ptx =
        compile_opencl("kernel void k(global float* a) { a[get_global_id(0)] = sin(a[1]) / a[2]; }", "a.cl",
                       options)
            .ptx;
    EXPECT_EQ(refusal([&] { Executable::compile(ptx, "k", TraceMode::blocks, "a.cl"); }), "");
  }
  EXPECT_THAT(refusal([] { compile_opencl("kernel void k() {}", "a.cl", "-cl-no-such-option"); }),
              HasSubstr("-cl-no-such-option"));
}

TEST(OpenClFrontend, FoldersOfIncludesAreCountedFromTheProgram) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "include");
  std::ofstream(folder.path() / "include" / "n.h") << "#define N 7654321\n";
  const std::string source = "#include <n.h>\nkernel void k(global int* a) { a[0] = N; }";
  for (const std::string& options :
       {std::string("-I include"), std::string("-Iinclude"), "-I" + (folder.path() / "include").string()})
    EXPECT_THAT(compile_opencl(source, (folder.path() / "k.cl").string(), options).ptx, HasSubstr("7654321"));
}

TEST(OpenClFrontend, WhatIsNotCarriedIsNamedWithItsPlace) {
  const auto refused = [](const std::string& source, const std::string& options = "") {
    return refusal([&] {
      Executable::compile(compile_opencl(source, "k.cl", options).ptx, "k", TraceMode::blocks, "k.cl");
    });
  };
  const std::string image = refused(
      "kernel void k(read_only image2d_t i, sampler_t s, global float4* o) {\n  o[0] = read_imagef(i, s, "
      "(int2)(0));\n}");
  EXPECT_THAT(image, HasSubstr("(k.cl:2): 'read_imagef': images and samplers are not carried"));
  EXPECT_THAT(
      refused("kernel void k(write_only image2d_t i) {\n\n  write_imagef(i, (int2)(0), (float4)(0));\n}"),
      HasSubstr("(k.cl:3): 'write_imagef': images"));
  EXPECT_THAT(
      refused("kernel void k(read_only pipe int p, global int* o) {\n  read_pipe(p, o);\n}", "-cl-std=CL2.0"),
      HasSubstr("(k.cl:2): '__read_pipe_2': pipes are not carried"));
  EXPECT_THAT(refused("kernel void k(global int* o) {\n  enqueue_kernel(get_default_queue(), "
                      "CLK_ENQUEUE_FLAGS_NO_WAIT, ndrange_1D(1), ^{ o[0] = 1; });\n}",
                      "-cl-std=CL2.0"),
              HasSubstr("device-side enqueue is not carried"));
}

// As NVIDIA's compiler has it: floats alone.
TEST(OpenClFrontend, FlushesSubnormalFloatsWhereItIsAskedTo) {
  const std::string source =
      "kernel void k(global float* a, global double* d) { a[0] = a[1] * a[2] + a[3]; d[0] = d[1] * d[2]; }";
  EXPECT_THAT(compile_opencl(source, "k.cl").ptx, Not(HasSubstr(".ftz")));
  const std::string flushing = compile_opencl(source, "k.cl", "-cl-denorms-are-zero").ptx;
  EXPECT_THAT(flushing, HasSubstr("fma.rn.ftz.f32"));
  EXPECT_THAT(flushing, HasSubstr("mul.rn.f64"));
}

TEST(OpenClFrontend, RefusesOptionsThatAreNotOpenCls) {
  EXPECT_THAT(refusal([] { compile_opencl("", "a.cl", "-o /etc/passwd"); }),
              HasSubstr("build options: unknown option '-o'; valid: -D"));
  EXPECT_THAT(refusal([] { compile_opencl("", "a.cl", "-D"); }), HasSubstr("a name behind it"));
  EXPECT_THAT(refusal([] { compile_opencl("", "a.cl", "-DA='x"); }), HasSubstr("a closing '"));
}

}  // namespace
}  // namespace warpgrain::profiler
