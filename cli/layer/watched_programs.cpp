// Programs, as they are made and built.

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cli/layer/watched_calls.hpp"

namespace warpgrain::layer {
namespace {

// One that makes a program without a source.
template <auto member, class Type = decltype(member)>
struct MakesUnknown;
template <auto member, class... Arguments>
struct MakesUnknown<member, cl_program (*cl_icd_dispatch::*)(Arguments...)> {
  static cl_program CL_API_CALL call(Arguments... arguments) {
    const cl_program program = (driver.*member)(arguments...);
    if (program != nullptr) noting([&] { recorder->programs.add_unknown(program, why()); });
    return program;
  }
  static const char* why() {
    if constexpr (std::is_same_v<decltype(member), decltype(&cl_icd_dispatch::clCreateProgramWithIL)>)
      return "a program made from SPIR-V";
    else if constexpr (std::is_same_v<decltype(member),
                                      decltype(&cl_icd_dispatch::clCreateProgramWithBuiltInKernels)>)
      return "a kernel built into the device";
    else
      return "a program made from a binary";
  }
};

cl_program CL_API_CALL create_program(cl_context context, cl_uint count, const char** strings,
                                      const size_t* lengths, cl_int* error) {
  const cl_program program = driver.clCreateProgramWithSource(context, count, strings, lengths, error);
  if (program == nullptr) return program;
  noting([&] {
    std::string source;
    for (cl_uint i = 0; i < count; ++i)
      source += lengths != nullptr && lengths[i] != 0 ? std::string_view(strings[i], lengths[i])
                                                      : std::string_view(strings[i]);
    recorder->programs.add_source(program, std::move(source));
  });
  return program;
}

void retain_program(cl_program program) { recorder->programs.retain(program); }
void release_program(cl_program program) { recorder->programs.release(program); }

// Noted before the driver builds: it may call back, or build in the background.
cl_int CL_API_CALL build_program(cl_program program, cl_uint n_devices, const cl_device_id* devices,
                                 const char* options, void(CL_CALLBACK* notify)(cl_program, void*),
                                 void* data) {
  noting([&] { recorder->programs.build(program, options); });
  return driver.clBuildProgram(program, n_devices, devices, options, notify, data);
}

cl_int CL_API_CALL compile_program(cl_program program, cl_uint n_devices, const cl_device_id* devices,
                                   const char* options, cl_uint n_headers, const cl_program* headers,
                                   const char** names, void(CL_CALLBACK* notify)(cl_program, void*),
                                   void* data) {
  noting([&] {
    const std::vector<cl_program> given(headers, headers + (headers != nullptr ? n_headers : 0));
    recorder->programs.compile(program, options, given, names);
  });
  return driver.clCompileProgram(program, n_devices, devices, options, n_headers, headers, names, notify,
                                 data);
}

cl_program CL_API_CALL link_program(cl_context context, cl_uint n_devices, const cl_device_id* devices,
                                    const char* options, cl_uint n_inputs, const cl_program* inputs,
                                    void(CL_CALLBACK* notify)(cl_program, void*), void* data, cl_int* error) {
  const cl_program program =
      driver.clLinkProgram(context, n_devices, devices, options, n_inputs, inputs, notify, data, error);
  if (program != nullptr) noting([&] { recorder->programs.link(program, {inputs, inputs + n_inputs}); });
  return program;
}

}  // namespace

void watch_programs(cl_icd_dispatch& table) {
  using Table = cl_icd_dispatch;
  table.clCreateProgramWithSource = create_program;
  table.clCreateProgramWithBinary = MakesUnknown<&Table::clCreateProgramWithBinary>::call;
  table.clCreateProgramWithBuiltInKernels = MakesUnknown<&Table::clCreateProgramWithBuiltInKernels>::call;
  table.clCreateProgramWithIL = MakesUnknown<&Table::clCreateProgramWithIL>::call;
  table.clRetainProgram = noted_first<&Table::clRetainProgram, retain_program>;
  table.clReleaseProgram = noted_first<&Table::clReleaseProgram, release_program>;
  table.clBuildProgram = build_program;
  table.clCompileProgram = compile_program;
  table.clLinkProgram = link_program;
}

}  // namespace warpgrain::layer
