#pragma once
// Launch files, `.sim`: Oclgrind's format, with `file=PATH` added. A file holds the program, the kernel, the global and
// the local size, then an argument each.

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "profiler/launch.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::profiler {

// Bytes aligned as a GPU aligns a buffer.
class DeviceBuffer {
 public:
  explicit DeviceBuffer(std::size_t bytes);
  ~DeviceBuffer();
  DeviceBuffer(DeviceBuffer&&) noexcept;
  DeviceBuffer& operator=(DeviceBuffer&&) noexcept;
  std::span<std::byte> bytes() const { return {data_, size_}; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

// One `<size=... ...>` entry of the file, parsed.
struct LaunchFileArgument {
  std::size_t size = 0;
  std::string type;      // float, int, uint4, ...; decides how values are read and dumped
  bool dump = false, hex = false, is_null = false, no_init = false, read_only = false, write_only = false;
  std::vector<std::byte> initial;  // [size] unless null, no_init or local
  bool has_data = false;           // fill, range, values or file stood there
  int line = 0;                    // where, for messages
};

struct LaunchFile {
  std::filesystem::path path;
  std::filesystem::path program;  // resolved against the launch file's folder
  std::string kernel;
  LaunchShape shape;
  std::vector<LaunchFileArgument> arguments;
};

// Throws InputError with file and line.
LaunchFile read_launch_file(const std::filesystem::path& path);

struct LaunchFileResult {
  LaunchProfile profile;
  std::vector<DeviceBuffer> buffers;  // one an argument; empty for scalars and local memory
};

// Compiles and profiles the launch. Prints the `dump`ed arguments to `out` as Oclgrind prints them.
LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out);

}  // namespace warpgrain::profiler
