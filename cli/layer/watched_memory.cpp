// Memory objects and samplers: whether a handle is still one.

#include "cli/layer/watched_calls.hpp"

namespace warpgrain::layer {
namespace {

// A function of the driver that makes a memory object or a sampler.
template <auto member, class Type = decltype(member)>
struct Makes;
template <auto member, class Handle, class... Arguments>
struct Makes<member, Handle (*cl_icd_dispatch::*)(Arguments...)> {
  static Handle CL_API_CALL call(Arguments... arguments) {
    const Handle handle = (driver.*member)(arguments...);
    if (handle != nullptr) noting([&] { recorder->handles.add(handle); });
    return handle;
  }
};

cl_int CL_API_CALL retain_memory(cl_mem memory) {
  noting([&] { recorder->handles.retain(memory); });
  return driver.clRetainMemObject(memory);
}

// Released here first: behind the driver's release another thread may get a new object of the same handle.
cl_int CL_API_CALL release_memory(cl_mem memory) {
  noting([&] { recorder->handles.release(memory); });
  return driver.clReleaseMemObject(memory);
}

cl_int CL_API_CALL retain_sampler(cl_sampler sampler) {
  noting([&] { recorder->handles.retain(sampler); });
  return driver.clRetainSampler(sampler);
}

cl_int CL_API_CALL release_sampler(cl_sampler sampler) {
  noting([&] { recorder->handles.release(sampler); });
  return driver.clReleaseSampler(sampler);
}

template <auto... members>
void watch_making(cl_icd_dispatch& table) {
  ((table.*members = Makes<members>::call), ...);
}

}  // namespace

void watch_memory(cl_icd_dispatch& table) {
  using Table = cl_icd_dispatch;
  watch_making<&Table::clCreateBuffer, &Table::clCreateBufferWithProperties, &Table::clCreateSubBuffer,
               &Table::clCreateImage, &Table::clCreateImage2D, &Table::clCreateImage3D,
               &Table::clCreateImageWithProperties, &Table::clCreatePipe, &Table::clCreateFromGLBuffer,
               &Table::clCreateFromGLTexture2D, &Table::clCreateFromGLTexture3D,
               &Table::clCreateFromGLTexture, &Table::clCreateFromGLRenderbuffer, &Table::clCreateSampler,
               &Table::clCreateSamplerWithProperties>(table);
  table.clRetainMemObject = retain_memory;
  table.clReleaseMemObject = release_memory;
  table.clRetainSampler = retain_sampler;
  table.clReleaseSampler = release_sampler;
}

}  // namespace warpgrain::layer
