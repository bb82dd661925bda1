#pragma once
// The calls that the layer watches: functions that note what they see and call the driver's. Those
// declared here put them into a table.

#include <CL/cl_icd.h>
#include <utility>

#include "cli/layer/recorder.hpp"

namespace warpgrain::layer {

// Set once, before any of the functions can be called. The recorder is never destroyed: applications use
// OpenCL until their very end.
inline cl_icd_dispatch driver;
inline Recorder* recorder = nullptr;

// What is noted of a call must not stop the application.
template <typename Function>
void noting(Function&& function) noexcept {
  try {
    function();
  } catch (...) {
    // Without memory for the note the object stays unknown, and launches that use it are not recorded.
  }
}

// The driver's function of that name for one object, which is noted first: behind the driver's release
// another thread may get a new object of the same handle.
template <auto member, auto note, class Object>
cl_int CL_API_CALL noted_first(Object object) {
  noting([&] { note(object); });
  return (driver.*member)(object);
}

void watch_memory(cl_icd_dispatch& table);    // buffers, images, pipes and samplers
void watch_programs(cl_icd_dispatch& table);  // how they are made and built
void watch_kernels(cl_icd_dispatch& table);   // and their arguments
void watch_launches(cl_icd_dispatch& table);  // and what may hold them back

}  // namespace warpgrain::layer
