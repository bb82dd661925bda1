#include "cli/layer/programs.hpp"

namespace warpgrain::layer {

void Programs::add(cl_program program, ProgramText text) {
  const std::lock_guard lock(mutex_);
  programs_[program] = {1, std::make_shared<const ProgramText>(std::move(text))};
}

void Programs::add_source(cl_program program, std::string source) {
  add(program, {.source = std::move(source)});
}

void Programs::add_unknown(cl_program program, std::string why) { add(program, {.unknown = std::move(why)}); }

void Programs::retain(cl_program program) {
  const std::lock_guard lock(mutex_);
  if (const auto found = programs_.find(program); found != programs_.end()) ++found->second.references;
}

void Programs::release(cl_program program) {
  const std::lock_guard lock(mutex_);
  const auto found = programs_.find(program);
  if (found != programs_.end() && --found->second.references == 0) programs_.erase(found);
}

std::shared_ptr<const ProgramText> Programs::find(cl_program program) const {
  static const auto unseen =
      std::make_shared<const ProgramText>(ProgramText{.unknown = "a program whose making was not seen"});
  const auto found = programs_.find(program);
  return found == programs_.end() ? unseen : found->second.text;
}

std::shared_ptr<const ProgramText> Programs::text_of(cl_program program) const {
  const std::lock_guard lock(mutex_);
  return find(program);
}

void Programs::build(cl_program program, const char* options) { compile(program, options, {}, nullptr); }

void Programs::compile(cl_program program, const char* options, const std::vector<cl_program>& headers,
                       const char** header_names) {
  const std::lock_guard lock(mutex_);
  const auto found = programs_.find(program);
  if (found == programs_.end()) return;
  ProgramText text = *found->second.text;
  text.options = options ? options : "";
  text.folder = std::filesystem::current_path();
  text.headers.clear();
  for (std::size_t i = 0; i < headers.size(); ++i)
    text.headers.emplace_back(header_names[i], find(headers[i])->source);
  found->second.text = std::make_shared<const ProgramText>(std::move(text));
}

void Programs::link(cl_program program, const std::vector<cl_program>& inputs) {
  ProgramText text;
  {
    const std::lock_guard lock(mutex_);
    if (inputs.size() == 1)
      text = *find(inputs.front());
    else
      text.unknown = "a program linked from several";
  }
  add(program, std::move(text));
}

}  // namespace warpgrain::layer
