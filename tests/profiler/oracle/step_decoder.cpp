#include "tests/profiler/oracle/step_decoder.hpp"

namespace warpgrain::oracle {
namespace {

using Kind = Step::Kind;

class StepDecoder {
 public:
  StepDecoder(const ptx::Statement& statement, const Names& names) : statement_(statement), names_(names) {
    step_.statement = &statement;
    if (!statement.guard) return;
    step_.guard = named(statement.guard->predicate);
    step_.guard->negated = statement.guard->negated;
  }

  Step run() {
    const std::string& opcode = statement_.opcode;
    if (opcode == "ld" || opcode == "ldu") {
      access(Kind::load, 1, 0);
    } else if (opcode == "st") {
      access(Kind::store, 0, 1);
    } else if (opcode == "atom" || opcode == "red") {
      atomic(opcode == "atom");
    } else if (opcode == "bar" || opcode == "barrier") {
      barrier();
    } else if (opcode == "bra") {
      jump();
    } else if (opcode == "brx") {
      jump();
      step_.inputs = {source(0)};
    } else if (opcode == "ret" || opcode == "exit") {
      jump();
    } else if (opcode == "trap") {
      step_.kind = Kind::trap;
    } else if (opcode == "mov" && is_vector(1)) {
      pack();
    } else if (opcode == "mov" && is_vector(0)) {
      unpack();
    } else if (opcode != "call" && opcode != "membar" && opcode != "fence" && opcode != "prefetch") {
      compute();
    }
    return std::move(step_);
  }

 private:
  bool is_vector(std::size_t i) const { return statement_.operands.at(i).kind == ptx::Operand::Kind::vector; }

  Source named(const std::string& name) const {
    if (const auto found = names_.find(name); found != names_.end()) return found->second;
    Source special;
    special.kind = Source::Kind::special;
    special.special = name;
    return special;
  }

  Source source(const ptx::Operand& operand) const {
    using From = ptx::Operand::Kind;
    Source result;
    switch (operand.kind) {
      case From::name:
        if (operand.name == "_") return result;
        result = named(operand.name);
        result.negated = operand.negated;
        if (result.kind != Source::Kind::special) result.value += operand.value;
        return result;
      case From::address:
        result.kind = Source::Kind::bits;
        if (!operand.name.empty()) result = named(operand.name);
        result.value += operand.value;
        return result;
      case From::integer:
        result.kind = Source::Kind::bits;
        break;
      case From::float32:
        result.kind = Source::Kind::float32;
        break;
      case From::float64:
        result.kind = Source::Kind::float64;
        break;
      default:
        refuse(statement_, "the kind of an operand");
    }
    result.value = operand.value;
    return result;
  }
  Source source(std::size_t i) const { return source(statement_.operands.at(i)); }

  // The elements of a vector, or the operand alone.
  std::vector<Source> elements(std::size_t i) const {
    if (!is_vector(i)) return {source(i)};
    std::vector<Source> result;
    for (const ptx::Operand& element : statement_.operands[i].elements) result.push_back(source(element));
    return result;
  }

  void compute() {
    step_.kind = Kind::compute;
    for (auto* family :
         {integer_operation, float_operation, bit_operation, compare_operation, convert_operation}) {
      step_.operation = family(statement_);
      if (step_.operation.compute) break;
    }
    if (!step_.operation.compute) refuse(statement_, "the instruction");
    step_.outputs = {source(0)};
    for (std::size_t i = 1; i < statement_.operands.size(); ++i) step_.inputs.push_back(source(i));
    if (step_.inputs.size() != step_.operation.inputs.size()) refuse(statement_, "the number of operands");
  }

  ptx::ScalarType part_of(ptx::ScalarType type, std::size_t parts) const {
    return ptx::bits_type(static_cast<std::uint8_t>(type.bits / parts));
  }

  void pack() {
    step_.kind = Kind::pack;
    Modifiers modifiers(statement_);
    step_.inputs = elements(1);
    step_.outputs = {source(0)};
    step_.element = part_of(modifiers.take_type(), step_.inputs.size());
  }

  void unpack() {
    step_.kind = Kind::unpack;
    Modifiers modifiers(statement_);
    step_.outputs = elements(0);
    step_.inputs = {source(1)};
    step_.element = part_of(modifiers.take_type(), step_.outputs.size());
  }

  static constexpr std::initializer_list<const char*> spaces{"global", "shared", "const", "local", "param"};

  void access(Kind kind, std::size_t address, std::size_t values) {
    step_.kind = kind;
    Modifiers modifiers(statement_);
    modifiers.take_one_of({"volatile", "relaxed", "acquire", "release", "weak"});
    modifiers.take_one_of({"cta", "gpu", "sys"});
    modifiers.take_one_of({"ca", "cg", "cs", "lu", "cv", "wb", "wt"});
    modifiers.take("nc");
    const std::string space = modifiers.take_one_of(spaces);
    modifiers.take_one_of({"v2", "v4"});
    step_.element = modifiers.take_type();
    modifiers.finish();
    step_.counts_access = space != "const" && space != "local" && space != "param";
    step_.address = source(address);
    (kind == Kind::load ? step_.outputs : step_.inputs) = elements(values);
  }

  void atomic(bool returns_old) {
    step_.kind = Kind::atomic;
    step_.counts_access = true;
    Modifiers modifiers(statement_);
    modifiers.take_one_of({"relaxed", "acquire", "release", "acq_rel"});
    modifiers.take_one_of({"cta", "gpu", "sys"});
    modifiers.take_one_of(spaces);
    const std::string name =
        modifiers.take_one_of({"add", "min", "max", "and", "or", "xor", "exch", "cas", "inc", "dec"});
    step_.element = modifiers.take_type();
    modifiers.finish();
    step_.operation = atomic_operation(statement_, name, step_.element);
    std::size_t next = 0;
    if (returns_old) step_.outputs = {source(next++)};
    step_.address = source(next++);
    while (next < statement_.operands.size()) step_.inputs.push_back(source(next++));
  }

  void barrier() {
    step_.kind = Kind::barrier;
    Modifiers modifiers(statement_);
    modifiers.take("cta");
    if (!modifiers.take("sync")) refuse(statement_, "a barrier that is not .sync");
    modifiers.take("aligned");
    modifiers.finish();
    if (statement_.operands.size() != 1) refuse(statement_, "a barrier of some lanes");
  }

  void jump() { step_.kind = Kind::jump; }

  const ptx::Statement& statement_;
  const Names& names_;
  Step step_;
};

}  // namespace

Step decode_step(const ptx::Statement& statement, const Names& names) {
  return StepDecoder(statement, names).run();
}

}  // namespace warpgrain::oracle
