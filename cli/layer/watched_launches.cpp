// Launches, and the events of the application that may hold them back.

#include <optional>

#include "cli/layer/watched_calls.hpp"

namespace warpgrain::layer {
namespace {

cl_event CL_API_CALL create_user_event(cl_context context, cl_int* error) {
  const cl_event event = driver.clCreateUserEvent(context, error);
  if (event != nullptr) recorder->user_event_made();
  return event;
}

cl_int CL_API_CALL set_user_event(cl_event event, cl_int execution_status) {
  const cl_int status = driver.clSetUserEventStatus(event, execution_status);
  if (status == CL_SUCCESS) recorder->user_event_set();
  return status;
}

// `start` lets the launch go its way.
template <typename Start>
cl_int record(const Enqueued& launch, Start&& start) {
  const std::optional<PendingLaunch> pending = recorder->capture(launch);
  const cl_int status = start();
  if (pending && status == CL_SUCCESS) recorder->keep(*pending);
  return status;
}

cl_int CL_API_CALL enqueue_kernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                                  const size_t* offset, const size_t* global_size, const size_t* local_size,
                                  cl_uint n_wait, const cl_event* wait_list, cl_event* event) {
  return record({queue, kernel, dimensions, offset, global_size, local_size, n_wait, wait_list}, [&] {
    return driver.clEnqueueNDRangeKernel(queue, kernel, dimensions, offset, global_size, local_size, n_wait,
                                         wait_list, event);
  });
}

cl_int CL_API_CALL enqueue_task(cl_command_queue queue, cl_kernel kernel, cl_uint n_wait,
                                const cl_event* wait_list, cl_event* event) {
  static constexpr size_t one = 1;
  return record({queue, kernel, 1, nullptr, &one, &one, n_wait, wait_list},
                [&] { return driver.clEnqueueTask(queue, kernel, n_wait, wait_list, event); });
}

}  // namespace

void watch_launches(cl_icd_dispatch& table) {
  table.clCreateUserEvent = create_user_event;
  table.clSetUserEventStatus = set_user_event;
  table.clEnqueueNDRangeKernel = enqueue_kernel;
  table.clEnqueueTask = enqueue_task;
}

}  // namespace warpgrain::layer
