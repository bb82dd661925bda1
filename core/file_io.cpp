#include "core/file_io.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unistd.h>

#include "core/error.hpp"

namespace warpgrain {

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t limit) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw_input_error(path.string(), "no such file", "a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > limit)
    throw_input_error(path.string(), fmt::format("{} bytes", size), fmt::format("at most {} bytes", limit));
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (size > 0) text << file.rdbuf();
  if (!file || !text) throw_input_error(path.string(), "cannot be read");
  return std::move(text).str();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::path unfinished = path;
  unfinished += fmt::format(".{}.tmp", ::getpid());
  std::error_code error;
  {
    errno = 0;
    std::ofstream file(unfinished, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) error = std::error_code(errno ? errno : EIO, std::generic_category());
  }
  if (!error) std::filesystem::rename(unfinished, path, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw_input_error(path.string(), "cannot be written: " + error.message());
  }
}

}  // namespace warpgrain
