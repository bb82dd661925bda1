#!/usr/bin/env python3
"""How far a GPU's approximate functions of floats are off: every mantissa, against double. Prints JSON.

Needs NVIDIA's driver and nothing else. The largest relative errors are those of y against the function in double, in 2^-24;
the PTX ISA's bounds beside them are what the simulator's back end simt_approximate takes (profiler/ptx/displacement.hpp).
"""
import ctypes
import json
import struct
import sys

# Name, bound in 2^-24, f32 code from %x and %b to %y, f64 code from %u and %v to %w.
FUNCTIONS = [
    ("sqrt.approx.f32", 2, "sqrt.approx.f32 %y, %x;", "sqrt.rn.f64 %w, %u;"),
    ("rsqrt.approx.f32", 2 ** 1.1, "rsqrt.approx.f32 %y, %x;", "sqrt.rn.f64 %w, %u; rcp.rn.f64 %w, %w;"),
    ("rcp.approx.f32", 2, "rcp.approx.f32 %y, %x;", "rcp.rn.f64 %w, %u;"),
    ("div.approx.f32", 4, "div.approx.f32 %y, %b, %x;", "div.rn.f64 %w, %v, %u;"),
    ("div.full.f32", 4, "div.full.f32 %y, %b, %x;", "div.rn.f64 %w, %v, %u;"),
]
N = 1 << 24  # floats from 1 to 4


def ptx():
    body = ""
    for k, (_, _, approximate, exact) in enumerate(FUNCTIONS):
        body += f"""
  {approximate}
  {exact}
  cvt.f64.f32 %z, %y;
  sub.f64 %z, %z, %w;
  div.rn.f64 %z, %z, %w;
  abs.f64 %z, %z;
  mov.b64 %bits, %z;
  red.global.max.u64 [%out+{16 * k}], %bits;
  setp.eq.f64 %p, %z, 0d0000000000000000;
  cvt.rn.f32.f64 %y2, %w;
  setp.ne.f32 %p, %y, %y2;
  @%p red.global.add.u64 [%out+{16 * k + 8}], 1;"""
    return f""".version 7.0
.target sm_70
.address_size 64
.visible .entry measure(.param .u64 out)
{{
  .reg .pred %p; .reg .b32 %i, %n, %h; .reg .b64 %out, %bits; .reg .f32 %x, %b, %y, %y2; .reg .f64 %u, %v, %w, %z;
  ld.param.u64 %out, [out];
  mov.u32 %i, %ctaid.x; mov.u32 %n, %ntid.x; mov.u32 %h, %tid.x;
  mad.lo.u32 %i, %i, %n, %h;
  mul.lo.u32 %h, %i, 2654435761; shr.u32 %h, %h, 8; add.u32 %h, %h, 0x3f800000; mov.b32 %b, %h;
  add.u32 %i, %i, 0x3f800000; mov.b32 %x, %i;
  cvt.f64.f32 %u, %x; cvt.f64.f32 %v, %b;{body}
  ret;
}}
"""


def main():
    cuda = ctypes.CDLL("libcuda.so.1")

    def call(name, *arguments):
        status = getattr(cuda, name)(*arguments)
        if status != 0:
            sys.exit(f"{name}: CUDA error {status}")

    device, context, module, kernel = ctypes.c_int(), ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_void_p()
    memory, name, version = ctypes.c_uint64(), ctypes.create_string_buffer(100), ctypes.c_int()
    call("cuInit", 0)
    call("cuDeviceGet", ctypes.byref(device), 0)
    call("cuDeviceGetName", name, 100, device)
    call("cuDriverGetVersion", ctypes.byref(version))
    call("cuCtxCreate_v2", ctypes.byref(context), 0, device)
    call("cuModuleLoadData", ctypes.byref(module), ptx().encode())
    call("cuModuleGetFunction", ctypes.byref(kernel), module, b"measure")
    size = 16 * len(FUNCTIONS)
    call("cuMemAlloc_v2", ctypes.byref(memory), ctypes.c_size_t(size))
    call("cuMemsetD8_v2", memory, 0, ctypes.c_size_t(size))
    parameters = (ctypes.c_void_p * 1)(ctypes.cast(ctypes.pointer(memory), ctypes.c_void_p))
    call("cuLaunchKernel", kernel, N // 256, 1, 1, 256, 1, 1, 0, None, parameters, None)
    result = ctypes.create_string_buffer(size)
    call("cuMemcpyDtoH_v2", result, memory, ctypes.c_size_t(size))
    rows = []
    for k, (function, bound, _, _) in enumerate(FUNCTIONS):
        error, differing = struct.unpack_from("<dQ", result.raw, 16 * k)
        rows.append({"function": function, "largest_error": error * 2 ** 24, "bound": bound,
                     "not_correctly_rounded": differing / N})
    print(json.dumps({"device": name.value.decode(), "driver": version.value, "unit": "2^-24, relative",
                      "arguments": "all floats from 1 to 4", "functions": rows}, indent=2))


main()
