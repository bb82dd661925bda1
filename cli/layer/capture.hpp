#pragma once
// A launch as it is about to run: its index space, and what its kernel can read.

#include <CL/cl_icd.h>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/layer/kernels.hpp"
#include "profiler/launch_file.hpp"

namespace warpgrain::layer {

// What the application handed to clEnqueueNDRangeKernel.
struct Enqueued {
  cl_command_queue queue = nullptr;
  cl_kernel kernel = nullptr;
  cl_uint dimensions = 1;
  const std::size_t* offset = nullptr;
  const std::size_t* global_size = nullptr;
  const std::size_t* local_size = nullptr;
  cl_uint n_wait = 0;
  const cl_event* wait_list = nullptr;

  std::uint64_t work_items() const;
};

// An argument with its bytes in memory still.
struct CapturedArgument {
  bool is_buffer = false;
  profiler::LaunchFileArgument argument;  // of other kinds than buffers
  std::vector<std::byte> bytes;           // of a buffer
  bool read_only = false;
};

struct Capture {
  std::string unprofiled = {};  // why it cannot be; then the rest is empty
  std::string remark = {};      // what a launch file cannot say of it
  profiler::LaunchShape shape = {};
  std::vector<CapturedArgument> arguments = {};
};

// Throws InputError where a capture fails.
class Capturing {
 public:
  Capturing(const cl_icd_dispatch& cl, const Handles& handles) : cl_(cl), handles_(handles) {}

  // Bytes that its buffers take.
  std::uint64_t buffer_bytes(const Kernel& kernel) const;

  // Reads the buffers back on the launch's queue, behind what the launch waits for, and waits for them.
  Capture capture(const Kernel& kernel, const Enqueued& launch) const;

 private:
  // Why a launch file cannot hold this launch; empty: it can.
  std::string unprofiled(const Kernel& kernel, const Enqueued& launch) const;
  std::string unprofiled(cl_uint index, const Argument& argument) const;
  CapturedArgument capture(const Argument& argument, const Enqueued& launch) const;
  std::vector<std::byte> read(cl_mem buffer, const Enqueued& launch) const;
  profiler::LaunchShape shape_of(const Enqueued& launch) const;

  const cl_icd_dispatch& cl_;
  const Handles& handles_;
};

}  // namespace warpgrain::layer
