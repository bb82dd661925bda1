// What `record` is tested on: launches of several kernels on an in-order and an out-of-order queue, and an
// exit status of its own. Arguments: the file of the kernels, and how often to scale.

#define CL_HPP_TARGET_OPENCL_VERSION 300
#define CL_HPP_MINIMUM_OPENCL_VERSION 200
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int status_of_success = 7;  // which is no other program's

cl::Device first_device(const std::string& platform_name) {
  std::vector<cl::Platform> platforms;
  cl::Platform::get(&platforms);
  for (const cl::Platform& platform : platforms) {
    if (platform.getInfo<CL_PLATFORM_NAME>() != platform_name) continue;
    std::vector<cl::Device> devices;
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    return devices.at(0);
  }
  throw cl::Error(CL_DEVICE_NOT_FOUND, platform_name.c_str());
}

// Each with objects of its own, made and released while others launch.
void launch_from_threads(const cl::Context& context, const cl::Device& device, const cl::Program& program,
                         int times) {
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&] {
      const cl::CommandQueue queue(context, device);
      for (int i = 0; i < times; ++i) {
        std::vector<int> numbers(256, i);
        const cl::Buffer buffer(context, cl_mem_flags{CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR}, 1024,
                                numbers.data());
        cl::Kernel repeat(program, "repeat");
        repeat.setArg(0, buffer);
        queue.enqueueNDRangeKernel(repeat, cl::NullRange, 256, 64);
        queue.enqueueReadBuffer(buffer, CL_TRUE, 0, 1024, numbers.data());
      }
    });
  for (std::thread& thread : threads) thread.join();
}

int run(const std::string& source, int times, const std::string& platform_name) {
  const cl::Device device = first_device(platform_name);
  const cl::Context context(device);
  const cl::CommandQueue in_order(context, device);
  const cl::CommandQueue out_of_order(context, device, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  cl::Program program(context, source);
  program.build({device}, "-DSTRIDE=7");

  std::vector<float> x(1024);
  std::iota(x.begin(), x.end(), 0.0F);
  const cl::Buffer values(context, cl_mem_flags{CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR}, 4096, x.data());
  cl::Kernel scale(program, "scale");
  scale.setArg(0, values);
  scale.setArg(1, 0.5F);
  scale.setArg(2, 1000U);
  for (int i = 0; i < times; ++i) {
    in_order.enqueueNDRangeKernel(scale, cl::NullRange, 1024, 64);
    scale.setArg(1, 1.0F);
  }
  // Waits for what the other queue has done, and may not be read by the host.
  const cl::Buffer sums(context, CL_MEM_READ_WRITE | CL_MEM_HOST_NO_ACCESS, 120);
  cl::Kernel sum_groups(program, "sum_groups");
  sum_groups.setArg(0, values);
  sum_groups.setArg(1, sums);
  sum_groups.setArg(2, cl::Local(128));
  cl::Event scaled, zeroed;
  in_order.enqueueMarkerWithWaitList(nullptr, &scaled);
  in_order.flush();
  out_of_order.enqueueFillBuffer(sums, 0.0F, 0, 120, nullptr, &zeroed);
  const std::vector<cl::Event> before_sums{scaled, zeroed};
  out_of_order.enqueueNDRangeKernel(sum_groups, cl::NullRange, 960, 32, &before_sums);
  out_of_order.finish();

  std::vector<int> numbers(4096);
  std::iota(numbers.begin(), numbers.end(), 0);
  cl::Buffer all(context, cl_mem_flags{CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR}, 16384, numbers.data());
  const cl_buffer_region second_quarter{4096, 4096};
  cl::Kernel count_bits(program, "count_bits");
  const cl::Buffer part = all.createSubBuffer(0, CL_BUFFER_CREATE_TYPE_REGION, &second_quarter);
  count_bits.setArg(0, part);
  count_bits.setArg(1, sizeof(cl_mem), nullptr);
  in_order.enqueueNDRangeKernel(count_bits, cl::NullRange, cl::NDRange(32, 32));
  in_order.enqueueNDRangeKernel(count_bits, cl::NDRange(0, 8), cl::NDRange(32, 8));

  const cl::Image2D image(context, CL_MEM_WRITE_ONLY, cl::ImageFormat(CL_RGBA, CL_FLOAT), 8, 8);
  cl::Kernel paint(program, "paint");
  paint.setArg(0, image);
  in_order.enqueueNDRangeKernel(paint, cl::NullRange, cl::NDRange(8, 8));

  if (times > 1) launch_from_threads(context, device, program, times);

  in_order.enqueueReadBuffer(values, CL_TRUE, 0, 4096, x.data());
  in_order.enqueueReadBuffer(all, CL_TRUE, 0, 16384, numbers.data());
  std::cout << "sum " << std::accumulate(x.begin(), x.end(), 0.0) << ", bits "
            << std::accumulate(numbers.begin() + 1024, numbers.begin() + 2048, 0) << '\n';
  return status_of_success;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return EXIT_FAILURE;
  std::ifstream in(argv[1]);
  const std::string source{std::istreambuf_iterator<char>(in), {}};
  try {
    return run(source, std::atoi(argv[2]), argc > 3 ? argv[3] : "Portable Computing Language");
  } catch (const cl::Error& error) {
    std::cerr << error.what() << ": " << error.err() << '\n';
    return EXIT_FAILURE;
  }
}
