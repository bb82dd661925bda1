// Comparisons and selections.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::CmpInst;
using llvm::Value;

std::optional<CmpInst::Predicate> float_comparison(std::string_view name) {
  static const std::unordered_map<std::string_view, CmpInst::Predicate> table{
      {"eq", CmpInst::FCMP_OEQ},  {"ne", CmpInst::FCMP_ONE},  {"lt", CmpInst::FCMP_OLT},
      {"le", CmpInst::FCMP_OLE},  {"gt", CmpInst::FCMP_OGT},  {"ge", CmpInst::FCMP_OGE},
      {"equ", CmpInst::FCMP_UEQ}, {"neu", CmpInst::FCMP_UNE}, {"ltu", CmpInst::FCMP_ULT},
      {"leu", CmpInst::FCMP_ULE}, {"gtu", CmpInst::FCMP_UGT}, {"geu", CmpInst::FCMP_UGE},
      {"num", CmpInst::FCMP_ORD}, {"nan", CmpInst::FCMP_UNO},
  };
  const auto found = table.find(name);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

std::optional<CmpInst::Predicate> integer_comparison(std::string_view name, bool is_signed) {
  static const std::unordered_map<std::string_view, std::pair<CmpInst::Predicate, CmpInst::Predicate>> table{
      {"eq", {CmpInst::ICMP_EQ, CmpInst::ICMP_EQ}},   {"ne", {CmpInst::ICMP_NE, CmpInst::ICMP_NE}},
      {"lt", {CmpInst::ICMP_SLT, CmpInst::ICMP_ULT}}, {"le", {CmpInst::ICMP_SLE, CmpInst::ICMP_ULE}},
      {"gt", {CmpInst::ICMP_SGT, CmpInst::ICMP_UGT}}, {"ge", {CmpInst::ICMP_SGE, CmpInst::ICMP_UGE}},
      {"lo", {CmpInst::ICMP_ULT, CmpInst::ICMP_ULT}}, {"ls", {CmpInst::ICMP_ULE, CmpInst::ICMP_ULE}},
      {"hi", {CmpInst::ICMP_UGT, CmpInst::ICMP_UGT}}, {"hs", {CmpInst::ICMP_UGE, CmpInst::ICMP_UGE}},
  };
  const auto found = table.find(name);
  if (found == table.end()) return std::nullopt;
  return is_signed ? found->second.first : found->second.second;
}

// What a set or setp compares, and how the result is combined with a further predicate.
struct Comparison {
  Value* result = nullptr;
  std::string_view combination;  // and, or, xor, or empty

  Value* combine(Emitter& e, Value* value) const {
    if (combination.empty()) return value;
    Value* other = e.read(3, predicate_type);
    if (combination == "and") return e.ir.CreateAnd(value, other);
    return combination == "or" ? e.ir.CreateOr(value, other) : e.ir.CreateXor(value, other);
  }
};

std::string_view take_comparison(Emitter& e) {
  return e.modifiers().take_one_of({"eq", "ne", "lt", "le", "gt", "ge", "equ", "neu", "ltu", "leu", "gtu",
                                    "geu", "num", "nan", "lo", "ls", "hi", "hs"});
}

Comparison compare(Emitter& e, std::string_view name, bool flushes, ScalarType type) {
  Comparison comparison;
  comparison.combination = e.modifiers().take_one_of({"and", "or", "xor"});
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  if (flushes && type.is_float() && type.bits == 32) a = flush_subnormal(e, a), b = flush_subnormal(e, b);
  const auto predicate =
      type.is_float() ? float_comparison(name) : integer_comparison(name, type.is_signed());
  if (!predicate) e.refuse("a comparison");
  comparison.result = e.ir.CreateCmp(*predicate, a, b);
  return comparison;
}

void emit_setp(Emitter& e) {
  const std::string_view name = take_comparison(e);
  const bool flushes = e.modifiers().take("ftz");
  const Comparison comparison = compare(e, name, flushes, e.take_type());
  const Operand& target = e.operand(0);
  if (target.kind != Operand::Kind::pair)
    return e.write(comparison.combine(e, comparison.result), predicate_type);
  // p|q: q gets the opposite comparison, combined alike. Both are read before either is written.
  Value* p = comparison.combine(e, comparison.result);
  Value* q = comparison.combine(e, e.ir.CreateNot(comparison.result));
  e.write(target.elements[0], p, predicate_type);
  e.write(target.elements[1], q, predicate_type);
}

// True is all ones in an integer and 1.0 in a float.
void emit_set(Emitter& e) {
  const std::string_view name = take_comparison(e);
  const bool flushes = e.modifiers().take("ftz");
  const ScalarType to = e.take_type();
  const Comparison comparison = compare(e, name, flushes, e.take_type());
  Value* value = comparison.combine(e, comparison.result);
  e.write(to.is_float() ? e.ir.CreateUIToFP(value, e.type(to)) : e.ir.CreateSExt(value, e.type(to)), to);
}

void emit_selp(Emitter& e) {
  const ScalarType type = e.take_type();
  Value* when_true = e.read(1, type);
  Value* when_false = e.read(2, type);
  e.write(e.ir.CreateSelect(e.read(3, predicate_type), when_true, when_false), type);
}

// a when c >= 0, else b
void emit_slct(Emitter& e) {
  const bool flushes = e.modifiers().take("ftz");
  const ScalarType type = e.take_type();
  const ScalarType condition_type = e.take_type();
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  Value* c = e.read(3, condition_type);
  if (flushes && condition_type.is_float()) c = flush_subnormal(e, c);
  Value* zero = llvm::Constant::getNullValue(e.type(condition_type));
  Value* holds = condition_type.is_float() ? e.ir.CreateFCmpOGE(c, zero) : e.ir.CreateICmpSGE(c, zero);
  e.write(e.ir.CreateSelect(holds, a, b), type);
}

}  // namespace

const InstructionTable& compare_instructions() {
  static const InstructionTable table{
      {"setp", emit_setp}, {"set", emit_set}, {"selp", emit_selp}, {"slct", emit_slct}};
  return table;
}

}  // namespace warpgrain::profiler::ptx
