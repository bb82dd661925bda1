#include "cli/output.hpp"

#include <algorithm>
#include <iostream>
#include <system_error>

#include "core/error.hpp"
#include "core/file_io.hpp"

namespace warpgrain::cli {
namespace {

std::string& stored_command_line() {
  static std::string text;
  return text;
}

std::string quoted(std::string_view word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=,./:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) return std::string(word);
  std::string text(1, '\'');
  for (char c : word) {
    if (c == '\'')
      text.append("'\\''");
    else
      text.push_back(c);
  }
  text.push_back('\'');
  return text;
}

// The options of a call, whatever the program's path.
std::string without_resume(std::string_view call) {
  std::string text(call.substr(std::min(call.find(' '), call.size())));
  constexpr std::string_view resume = " --resume";
  const std::size_t place = text.find(resume);
  if (place != std::string::npos) text.erase(place, resume.size());
  return text;
}

}  // namespace

void write_output(const std::string& target, std::string_view text) {
  if (target == "-")
    std::cout << text;
  else {
    make_folder(std::filesystem::absolute(target).parent_path());
    write_file_atomically(target, text);
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw_input_error(folder.string(), "no folder can be made here", "a writable place");
}

const std::string& command_line() { return stored_command_line(); }

void set_command_line(int argc, const char* const* argv) {
  std::string text = "warpgrain";  // not the path that this machine has it under
  for (int k = 1; k < argc; ++k) text.append(" ").append(quoted(argv[k]));
  stored_command_line() = text;
}

void require_same_call(const std::string& file, std::string_view command_line_of_document) {
  if (without_resume(command_line_of_document) != without_resume(command_line()))
    throw_input_error(file, "the document of the call '" + std::string(command_line_of_document) + "'",
                      "that of this call, --resume aside");
}

}  // namespace warpgrain::cli
