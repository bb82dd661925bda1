#pragma once
// PTX made for OpenCL's driver, as CUDA's driver takes it, and assembled by either of NVIDIA's assemblers.

#include <string>
#include <string_view>

#include "variants/cuda_driver.hpp"

namespace warpgrain {

// Who turns PTX into machine code: the driver's own assembler, or the program ptxas, whose cubin can be
// listed. Both give the same code when they are of one version.
enum class CudaAssembler : std::uint8_t { driver, ptxas };
// Throws InputError that lists the valid names.
CudaAssembler cuda_assembler(std::string_view name, std::string_view where);

// Without what OpenCL's driver alone knows: the target's texmode_independent, parameters that are addresses
// of shared memory (they stay as plain numbers; the launch works out the addresses), and the registers
// %envregN, which hold the launch's offsets there and nothing here: 0. No instruction comes or goes. Throws
// InputError for pointers to constant memory, which CUDA passes no kernel.
std::string ptx_for_cuda(std::string_view ptx, std::string_view where);

struct CudaProgram {
  std::string ptx;        // as it was assembled
  std::string cubin;      // of ptxas; empty when the driver assembles
  std::string assembler;  // "driver 580.159.04, CUDA 13.0", or ptxas's version line
};

// `ptx` as the front ends give it. Throws InputError with ptxas's messages, or when there is no ptxas on PATH
// or in /usr/local/cuda/bin.
CudaProgram assemble_for_cuda(const CudaDevice& device, CudaAssembler assembler, std::string_view ptx,
                              std::string_view where);

// Loads the cubin, or else the PTX.
CudaModule load_program(const CudaDevice& device, const CudaProgram& program, std::string_view where);

}  // namespace warpgrain
