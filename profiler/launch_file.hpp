#pragma once
// Launch files, `.sim`: Oclgrind's format. A file names the program, the kernel, the global and the local
// size, then an argument each:
//
//   vector_add.cl           # comments run to the end of the line
//   vector_add
//   1024 1 1
//   64 1 1
//   <size=4096 float range=0:1:1023>
//   <size=4096 float fill=2 ro>
//   <size=4096 float noinit dump>
//   <size=4> 1024
//
// size=N    bytes; of local memory, a scalar or a buffer, as the kernel's signature says
// TYPE      char, uchar, short, ... double: of the values; else that of the kernel's parameter
// fill=V    all elements; range=A:S:B  A, A+S, ... B; noinit  none (zeros); else the values follow, size /
// size of TYPE of
//           them
// hex       whole numbers are hexadecimal, and dumped so;  null  a null pointer;  ro, wo  what the kernel may
// do (accepted) dump      print the buffer after the run
//
// A kernel that uses shared memory without a size (CUDA's `extern __shared__`) takes that size as one more
// argument behind the others: <size=N>.
//
// Beyond Oclgrind: `file=PATH` reads raw bytes, relative to the launch file; the program may be PTX (`.ptx`)
// or CUDA C++ (`.cu`).
// The program stands relative to the launch file, too, or else to the working directory. A file
// PROGRAM.options beside it, kernel.cl.options, holds build options that come before those of the call.

#include <array>
#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profiler/device_buffer.hpp"
#include "profiler/element_type.hpp"
#include "profiler/launch.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::profiler {

// One `<size=... ...>` entry, as it stands there.
struct LaunchFileArgument {
  struct Value {
    std::string text;
    int line = 0;
  };
  int line = 0;
  std::size_t size = 0;
  std::optional<ElementType> type;
  bool dump = false, hex = false, is_null = false, no_init = false, read_only = false, write_only = false;
  std::string fill, range;  // empty: not given
  std::filesystem::path file;
  std::vector<Value> values;  // that follow
};

struct LaunchFile {
  std::filesystem::path path;
  std::filesystem::path program;
  std::string program_name;   // what reports call it; empty: its path
  std::string build_options;  // of the program's own
  std::string kernel;
  LaunchShape shape;
  std::vector<LaunchFileArgument> arguments;
};

// Throws InputError with file and line.
LaunchFile read_launch_file(const std::filesystem::path& path);

// Arguments of given bytes. A buffer's go to the file `name` in `folder`, unless all are zero; one of none is
// null. Throws InputError when the file cannot be written.
LaunchFileArgument scalar_argument(std::span<const std::byte> value);
LaunchFileArgument buffer_argument(std::span<const std::byte> bytes, const std::string& name,
                                   const std::filesystem::path& folder);

// Where the build options of a program stand.
std::filesystem::path options_file(const std::filesystem::path& program);

// Writes the file to `file.path`, its program and files of arguments as paths that are meant relative to it.
// Throws InputError when it cannot be written.
void write_launch_file(const LaunchFile& file);

struct LaunchFileResult {
  LaunchProfile profile;
  std::vector<DeviceBuffer> buffers;  // one an argument; empty for scalars and local memory
};

class CompiledLaunches;

// Compiles and profiles the launch; what `compiled` holds is taken from there. Prints what the kernel prints
// to `out`, then the `dump`ed arguments as Oclgrind prints them. Throws InputError for a program that does
// not compile, a kernel that is not there, and arguments that do not fit its parameters.
LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out);
LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out,
                                     CompiledLaunches& compiled);

}  // namespace warpgrain::profiler
