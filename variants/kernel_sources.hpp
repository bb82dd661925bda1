#pragma once
// The text of the kernels: the files embedded at build time, or those of a folder that stand in for them.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain {

class KernelSources {
 public:
  // Files of `folder` (below it as they are below kernels/) shadow the embedded ones; empty: no folder.
  // Throws InputError when the folder is not there or shadows nothing.
  explicit KernelSources(const std::filesystem::path& folder = {});

  // One text to compile: `files` one after another, every #include "file" in them replaced by that file,
  // once. #line keeps file and line true in messages and profiles. Throws InputError naming file and line of
  // an #include of a file that is not there.
  std::string bundle(std::span<const std::string> files) const;

 private:
  struct File {
    std::string shown_path;  // as messages and profiles name it
    std::string text;
  };
  bool find(std::string_view path, File& file) const;
  void append(std::string_view path, std::string_view included_from, std::string& text,
              std::vector<std::string>& done) const;

  std::filesystem::path folder_;
};

}  // namespace warpgrain
