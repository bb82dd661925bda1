#include "reports/atomic_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what, int system_error) {
  throw_input_error(path.string(), what + ": " + std::generic_category().message(system_error));
}

// Removes the file it names unless it was told to keep it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : name_(target.string() + ".XXXXXX") {
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) refuse(target, "cannot be written", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t n = ::write(descriptor_, content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return false;
      content.remove_prefix(static_cast<std::size_t>(n));
    }
    // mkstemp's files are for the owner alone; results get what the user's mask leaves, as other files do.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return ::fchmod(descriptor_, 0666 & ~mask) == 0;
  }

  bool rename_to(const std::filesystem::path& target) {
    const bool closed = ::close(descriptor_) == 0;
    descriptor_ = -1;
    renamed_ = closed && ::rename(name_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  if (path.has_parent_path()) {
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error) refuse(path.parent_path(), "cannot be made a folder", error.value());
  }
  TemporaryFile file(path);
  if (!file.write(content)) refuse(path, "cannot be written", errno);
  if (!file.rename_to(path)) refuse(path, "cannot be written", errno);
}

}  // namespace warpgrain::reports
