#include "profiler/ptx/body_parser.hpp"

#include <fmt/format.h>

#include "profiler/ptx/declaration_parser.hpp"

namespace warpgrain::profiler::ptx {
namespace {

class BodyParser {
 public:
  BodyParser(TokenCursor& cursor, Function& function) : cursor_(cursor), function_(function) {}

  void run() {
    const std::uint32_t opened = cursor_.peek().line;
    cursor_.expect('{');
    scopes_.emplace_back();
    while (!scopes_.empty()) {
      if (cursor_.at_end())
        cursor_.refuse_at(opened, fmt::format("the body of '{}' opens here", function_.name), "its end, '}'");
      parse_item();
    }
  }

 private:
  void parse_item() {
    const Token& token = cursor_.peek();
    if (cursor_.take_if('{')) {
      scopes_.emplace_back();
    } else if (cursor_.take_if('}')) {
      scopes_.pop_back();
    } else if (token.kind == Token::Kind::directive) {
      parse_directive();
    } else if (at_label()) {
      parse_label();
    } else {
      parse_statement();
    }
  }

  void parse_directive() {
    const std::string_view name = cursor_.take().text;
    if (name == "reg") return parse_registers();
    if (name == "loc") return parse_location();
    if (name == "pragma") {
      while (!cursor_.take_if(';')) cursor_.expect_string("a pragma's text"), cursor_.take_if(',');
      return;
    }
    const auto space = state_space(name);
    if (!space)
      cursor_.refuse(fmt::format("directive '.{}' in a body", name), "a declaration, .loc or .pragma");
    for (Variable& variable : parse_variables(cursor_, *space)) {
      variable.name = declare(variable.name);
      function_.variables.push_back(std::move(variable));
    }
  }

  // `.reg .b32 %r<5>, %other;`: %r0 to %r4 and %other
  void parse_registers() {
    // No instruction that is carried has 128 bits; one that has names a register that is not there.
    if (cursor_.take_if_directive("b128")) return cursor_.skip_behind(';');
    const auto type =
        cursor_.peek().kind == Token::Kind::directive ? scalar_type(cursor_.peek().text) : std::nullopt;
    if (!type) cursor_.refuse_next("a scalar type");
    cursor_.take();
    do {
      const std::string name = cursor_.expect_name("a register");
      if (!cursor_.take_if('<')) {
        function_.registers.emplace_back(declare(name), *type);
        continue;
      }
      const std::uint64_t count = cursor_.expect_integer("a number of registers");
      if (count > max_registers)
        cursor_.refuse(fmt::format("{} registers", count), fmt::format("at most {}", max_registers));
      cursor_.expect('>');
      for (std::uint64_t i = 0; i < count; ++i)
        function_.registers.emplace_back(declare(fmt::format("{}{}", name, i)), *type);
    } while (cursor_.take_if(','));
    cursor_.expect(';');
  }

  // `.loc 1 30 5` or `.loc 1 30 5, function_name $L__info_string0, inlined_at 1 50 3`. The line is that of
  // the inlined text itself: there the user sees the instruction.
  void parse_location() {
    location_.file = static_cast<std::uint32_t>(cursor_.expect_integer("a file's number"));
    location_.line = static_cast<std::uint32_t>(cursor_.expect_integer("a line"));
    cursor_.expect_integer("a column");
    while (cursor_.take_if(',')) {
      const std::string name = cursor_.expect_name("function_name or inlined_at");
      if (name == "function_name") {
        cursor_.expect_name("a label");
        if (cursor_.take_if('+')) cursor_.expect_integer("an offset");
      } else if (name == "inlined_at") {
        for (int i = 0; i < 3; ++i) cursor_.expect_integer("file, line and column");
      } else {
        cursor_.refuse(fmt::format("'{}'", name), "function_name or inlined_at");
      }
    }
  }

  bool at_label() const { return cursor_.peek().kind == Token::Kind::identifier && cursor_.peek(1).is(':'); }

  void parse_label() {
    const std::uint32_t line = cursor_.peek().line;
    const std::string name = cursor_.expect_name("a label");
    cursor_.expect(':');
    if (cursor_.take_if_directive("branchtargets"))
      return parse_names(function_.branch_tables[name], "a label");
    // A prototype says what the arguments of its calls say as well.
    if (cursor_.take_if_directive("callprototype")) return cursor_.skip_behind(';');
    if (cursor_.take_if_directive("calltargets"))
      return parse_names(function_.call_targets[name], "a function");
    if (!function_.labels.emplace(name, function_.statements.size()).second)
      cursor_.refuse_at(line, fmt::format("label '{}' stands twice in '{}'", name, function_.name));
  }

  // `first, second;`
  void parse_names(std::vector<std::string>& names, std::string_view what) {
    do {
      names.push_back(cursor_.expect_name(what));
    } while (cursor_.take_if(','));
    cursor_.expect(';');
  }

  void parse_statement() {
    const Token& first = cursor_.peek();
    Statement statement;
    statement.line = first.line;
    statement.location = location_;
    if (cursor_.take_if('@')) {
      Guard guard;
      guard.negated = cursor_.take_if('!');
      guard.predicate = resolve(cursor_.expect_name("a predicate"));
      statement.guard = guard;
    }
    statement.opcode = cursor_.expect_name("an instruction");
    while (cursor_.peek().kind == Token::Kind::directive)
      statement.modifiers.emplace_back(cursor_.take().text);
    if (!cursor_.peek().is(';')) {
      do {
        statement.operands.push_back(parse_operand());
      } while (cursor_.take_if(','));
    }
    cursor_.expect(';');
    statement.text = cursor_.text_since(first);
    function_.statements.push_back(std::move(statement));
  }

  Operand parse_operand() {
    // LLVM prints a call in parts and puts the labels of line tables between them.
    while (at_label()) parse_label();
    Operand operand;
    const Token& token = cursor_.peek();
    if (cursor_.take_if('!')) {
      operand.negated = true;
      operand.name = resolve(cursor_.expect_name("a predicate"));
    } else if (token.is('[')) {
      parse_address(operand);
    } else if (cursor_.take_if('{')) {
      operand.kind = Operand::Kind::vector;
      parse_elements(operand, '}');
    } else if (cursor_.take_if('(')) {
      operand.kind = Operand::Kind::list;
      parse_elements(operand, ')');
    } else if (token.kind == Token::Kind::identifier) {
      parse_named(operand);
    } else if (token.kind == Token::Kind::float32 || token.kind == Token::Kind::float64) {
      operand.kind = token.kind == Token::Kind::float32 ? Operand::Kind::float32 : Operand::Kind::float64;
      operand.value = cursor_.take().value;
    } else {
      operand.kind = Operand::Kind::integer;
      operand.value = cursor_.expect_signed_integer("an operand");
    }
    return operand;
  }

  // Register, symbol, symbol+8, %tid.x, or p|q.
  void parse_named(Operand& operand) {
    operand.name = resolve(cursor_.expect_name("an operand"));
    if (cursor_.peek().kind == Token::Kind::directive) {
      operand.name += '.';
      operand.name += cursor_.take().text;
    }
    if (cursor_.take_if('+')) operand.value = cursor_.expect_signed_integer("an offset");
    if (cursor_.take_if('|')) {
      Operand second;
      parse_named(second);
      Operand first_of_pair = std::move(operand);
      operand = {};
      operand.kind = Operand::Kind::pair;
      operand.elements = {std::move(first_of_pair), std::move(second)};
    }
  }

  void parse_address(Operand& operand) {
    operand.kind = Operand::Kind::address;
    cursor_.expect('[');
    if (cursor_.peek().kind == Token::Kind::identifier) {
      operand.name = resolve(cursor_.expect_name("an address"));
      if (cursor_.take_if('+') || cursor_.peek().is('-'))
        operand.value = cursor_.expect_signed_integer("an offset");
    } else {
      operand.value = cursor_.expect_signed_integer("an address");
    }
    // Coordinates, of textures and the like; their instructions are refused where they are run.
    while (cursor_.take_if(',')) operand.elements.push_back(parse_operand());
    if (!cursor_.take_if(']')) cursor_.refuse_next("']'");
  }

  void parse_elements(Operand& operand, char close) {
    while (!cursor_.take_if(close)) {
      operand.elements.push_back(parse_operand());
      if (!cursor_.peek().is(close)) cursor_.expect(',');
    }
  }

  // Names are unique in the function: those of inner braces (call sequences, inline assembly) get a number.
  std::string declare(const std::string& name) {
    std::string unique = scopes_.size() == 1 ? name : fmt::format("{}@{}", name, ++renamed_);
    if (!scopes_.back().emplace(name, unique).second)
      cursor_.refuse(fmt::format("'{}' is declared twice in '{}'", name, function_.name));
    return unique;
  }

  std::string resolve(const std::string& name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
      if (const auto found = scope->find(name); found != scope->end()) return found->second;
    return name;
  }

  static constexpr std::uint64_t max_registers = 1 << 20;
  TokenCursor& cursor_;
  Function& function_;
  std::vector<std::unordered_map<std::string, std::string>> scopes_;
  std::size_t renamed_ = 0;
  SourceLocation location_;
};

}  // namespace

void parse_body(TokenCursor& cursor, Function& function) { BodyParser(cursor, function).run(); }

}  // namespace warpgrain::profiler::ptx
