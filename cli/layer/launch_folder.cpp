#include "cli/layer/launch_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <iterator>
#include <string_view>
#include <unistd.h>

#include "core/error.hpp"
#include "profiler/build_options.hpp"

namespace warpgrain::layer {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw_input_error(path.string(), "cannot be written", "a folder to write to");
}

void write(const std::filesystem::path& path, std::string_view text) {
  std::ofstream out(path, std::ios::binary);
  if (!out.write(text.data(), static_cast<std::streamsize>(text.size())).flush()) refuse(path);
}

// As split_words takes it.
std::string escaped(std::string_view word) {
  std::string text;
  for (const char c : word) {
    if (std::string_view(" \t\n\"'\\").find(c) != std::string_view::npos) text += '\\';
    text += c;
  }
  return text;
}

std::string include(const std::filesystem::path& folder) { return fmt::format("-I{}", folder.string()); }

// With folders of -I that hold from everywhere: the application's own folder is where its compiler starts.
std::string options_of(const ProgramText& program, const std::string& folder_of_headers) {
  std::vector<std::string> words = profiler::split_words(program.options);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "-I" && i + 1 < words.size())
      words[i + 1] = (program.folder / words[i + 1]).string();
    else if (words[i].starts_with("-I") && words[i].size() > 2)
      words[i] = include(program.folder / words[i].substr(2));
  }
  if (!folder_of_headers.empty()) words.push_back(include(folder_of_headers));
  if (program.source.find("#include") != std::string::npos) words.push_back(include(program.folder));
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(escaped(word));
  return text;
}

// FNV-1a over words of 8 bytes, for names; contents are compared.
std::uint64_t hash_of(std::span<const std::byte> bytes) {
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t hash = 0xcbf29ce484222325;
  std::uint64_t word = 0;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof word) {
    word = 0;
    std::copy_n(bytes.data() + at, std::min(sizeof word, bytes.size() - at),
                reinterpret_cast<std::byte*>(&word));
    hash = (hash ^ word) * prime;
    hash ^= hash >> 29;
  }
  return hash;
}

bool holds(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ifstream in(path, std::ios::binary);
  std::vector<char> part(std::size_t{1} << 16);
  for (std::size_t at = 0; in && at < bytes.size();) {
    const std::size_t size = std::min(part.size(), bytes.size() - at);
    if (!in.read(part.data(), static_cast<std::streamsize>(size))) return false;
    if (!std::equal(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(size),
                    reinterpret_cast<const char*>(bytes.data()) + at))
      return false;
    at += size;
  }
  return in && in.peek() == std::char_traits<char>::eof();
}

}  // namespace

LaunchFolder::LaunchFolder(std::filesystem::path folder, std::uint64_t memory)
    : folder_(std::move(folder)), memory_(memory) {
  append_to_index("");  // so that `record` can tell that the layer was there
}

// The first number that no other process has taken.
std::string LaunchFolder::claim(const std::string& stem, const std::string& extension, int& number) {
  for (;; ++number) {
    const std::string name = fmt::format("{}-{:04}{}", stem, number, extension);
    const int file = open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file >= 0) {
      close(file);
      ++number;
      return name;
    }
    if (errno != EEXIST) refuse(folder_ / name);
  }
}

void LaunchFolder::append_to_index(const std::string& line) {
  const std::filesystem::path path = folder_ / cli::record_index;
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) refuse(path);
  // In one call, so that lines of several processes stay whole.
  const ssize_t written = ::write(file, line.data(), line.size());
  close(file);
  if (written != static_cast<ssize_t>(line.size())) refuse(path);
}

profiler::LaunchFileArgument LaunchFolder::add_buffer(std::span<const std::byte> bytes) {
  const std::string name = fmt::format("buffer-{:016x}-{}", hash_of(bytes), bytes.size());
  const std::lock_guard lock(mutex_);
  for (int copy = 0;; ++copy) {
    const std::string file = copy == 0 ? name : fmt::format("{}-{}", name, copy);
    if (!std::filesystem::exists(folder_ / file)) {
      // Whole before others see it.
      const std::string unfinished = fmt::format("{}.{}", file, getpid());
      profiler::LaunchFileArgument argument = profiler::buffer_argument(bytes, unfinished, folder_);
      if (argument.file.empty()) return argument;
      std::filesystem::rename(folder_ / unfinished, folder_ / file);
      argument.file = file;
      used_ += bytes.size();
      return argument;
    }
    if (!holds(folder_ / file, bytes)) continue;
    profiler::LaunchFileArgument argument;
    argument.size = bytes.size();
    argument.type = profiler::ElementType::u8;
    argument.file = file;
    return argument;
  }
}

std::string LaunchFolder::add_program(const std::shared_ptr<const ProgramText>& program) {
  const std::lock_guard lock(mutex_);
  for (const auto& [known, file] : programs_)
    if (known == program || *known == *program) return file;
  const std::string file = claim("program", ".cl", next_program_);
  std::string folder_of_headers;
  for (const auto& [name, text] : program->headers) {
    folder_of_headers = (folder_ / (file + ".headers")).string();
    const std::filesystem::path header = std::filesystem::path(folder_of_headers) / name;
    std::filesystem::create_directories(header.parent_path());
    write(header, text);
  }
  if (const std::string options = options_of(*program, folder_of_headers); !options.empty())
    write(profiler::options_file(folder_ / file), options + '\n');
  write(folder_ / file, program->source);
  programs_.emplace_back(program, file);
  return file;
}

void LaunchFolder::add_launch(profiler::LaunchFile file, const std::string& remark) {
  const std::lock_guard lock(mutex_);
  const std::string name = claim("launch", ".sim", next_launch_);
  file.path = folder_ / name;
  write_launch_file(file);
  append_to_index(cli::index_line({file.kernel, name, remark}));
}

void LaunchFolder::add_unrecorded(const std::string& kernel, const std::string& why) {
  const std::lock_guard lock(mutex_);
  append_to_index(cli::index_line({kernel, "", why}));
}

}  // namespace warpgrain::layer
