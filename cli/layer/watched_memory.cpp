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

void retain_memory(const void* handle) { recorder->handles.retain(handle); }
void release_memory(const void* handle) { recorder->handles.release(handle); }

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
  table.clRetainMemObject = noted_first<&Table::clRetainMemObject, retain_memory>;
  table.clReleaseMemObject = noted_first<&Table::clReleaseMemObject, release_memory>;
  table.clRetainSampler = noted_first<&Table::clRetainSampler, retain_memory>;
  table.clReleaseSampler = noted_first<&Table::clReleaseSampler, release_memory>;
}

}  // namespace warpgrain::layer
