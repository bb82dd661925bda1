#include "profiler/ptx/parser.hpp"

#include <filesystem>
#include <fmt/format.h>

#include "profiler/ptx/body_parser.hpp"
#include "profiler/ptx/declaration_parser.hpp"
#include "profiler/ptx/token_cursor.hpp"

namespace warpgrain::profiler::ptx {
namespace {

class ModuleParser {
 public:
  ModuleParser(std::string_view text, std::string_view where)
      : tokens_(tokenize(text, where)), cursor_(tokens_, text, where) {}

  Module run() {
    if (!cursor_.peek().is_directive("version")) cursor_.refuse_next("'.version', which PTX begins with");
    while (!cursor_.at_end()) parse_directive();
    return std::move(module_);
  }

 private:
  void parse_directive() {
    if (cursor_.peek().kind != Token::Kind::directive) cursor_.refuse_next("a directive");
    const std::string_view name = cursor_.take().text;
    if (name == "version") {
      cursor_.take();
    } else if (name == "target") {
      while (cursor_.peek().kind == Token::Kind::identifier || cursor_.peek().is(','))
        module_.is_opencl |= cursor_.take().text == "texmode_independent";
    } else if (name == "address_size") {
      if (cursor_.expect_integer("64") != 64) cursor_.refuse("an address size other than 64", "64-bit PTX");
    } else if (name == "file") {
      parse_file();
    } else if (name == "section") {
      cursor_.take();
      cursor_.skip_braces();
    } else if (name == "pragma") {
      cursor_.expect_string("a pragma's text");
      cursor_.expect(';');
    } else if (name == "visible" || name == "weak" || name == "common") {
      // Linkage matters to no single module.
    } else if (name == "alias") {
      const std::string alias = cursor_.expect_name("a function's other name");
      cursor_.expect(',');
      module_.aliases[alias] = cursor_.expect_name("a function");
      cursor_.expect(';');
    } else if (name == "extern") {
      external_ = true;
    } else if (name == "entry" || name == "func") {
      parse_function(name == "entry");
    } else if (const auto space = state_space(name)) {
      for (Variable& variable : parse_variables(cursor_, *space)) {
        variable.external = external_;
        module_.variables.push_back(std::move(variable));
      }
      external_ = false;
    } else {
      cursor_.refuse(fmt::format("directive '.{}'", name), "a declaration, a function or .file");
    }
  }

  // `.file 1 "path"`, `.file 1 "directory" "path"`, either with `, time, size` behind.
  void parse_file() {
    const auto number = static_cast<std::uint32_t>(cursor_.expect_integer("a file's number"));
    std::filesystem::path path = cursor_.expect_string("a file's name");
    if (cursor_.peek().kind == Token::Kind::string) path /= cursor_.expect_string("a file's name");
    while (cursor_.take_if(',')) cursor_.expect_integer("a time or size");
    module_.files[number] = path.lexically_normal().string();
  }

  void parse_function(bool is_entry) {
    Function function;
    function.is_entry = is_entry;
    if (!is_entry && cursor_.peek().is('(')) function.results = parse_parameters(cursor_);
    function.line = cursor_.peek().line;
    function.name = cursor_.expect_name("a function's name");
    if (cursor_.peek().is('(')) function.parameters = parse_parameters(cursor_);
    parse_performance_directives(function);
    if (!cursor_.take_if(';')) {
      parse_body(cursor_, function);
      function.has_body = true;
    }
    external_ = false;
    module_.functions.push_back(std::move(function));
  }

  // .maxntid and the like advise the assembler; .reqntid is a promise that a launch must keep.
  void parse_performance_directives(Function& function) {
    while (cursor_.peek().kind == Token::Kind::directive) {
      const std::string_view name = cursor_.take().text;
      std::array<std::uint32_t, 3> values{1, 1, 1};
      for (std::size_t i = 0; cursor_.peek().kind == Token::Kind::integer;) {
        const std::uint64_t value = cursor_.expect_integer("a number");
        if (i < values.size()) values[i++] = static_cast<std::uint32_t>(value);
        cursor_.take_if(',');
      }
      if (name == "reqntid") function.required_local_size = values;
    }
  }

  std::vector<Token> tokens_;
  TokenCursor cursor_;
  Module module_;
  bool external_ = false;
};

}  // namespace

Module parse(std::string_view text, std::string_view where) {
  // NVIDIA's compiler ends its text with NUL bytes.
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  return ModuleParser(text, where).run();
}

}  // namespace warpgrain::profiler::ptx
