#include "tests/proofs/coq_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace flowcert::proofs {

namespace {

using Tree = DecisionTree<CoqAnswer>;

constexpr std::size_t kColumns = 120;

std::string in(bool brackets, const std::string& text) { return brackets ? "(" + text + ")" : text; }

const char* text_of(Relation relation) {
  switch (relation) {
    case Relation::kLess:
      return "Less";
    case Relation::kLessEqual:
      return "LessEqual";
    case Relation::kEqual:
      return "Equal";
  }
  throw std::logic_error("no relation");
}

const char* text_of(Operation operation) {
  switch (operation) {
    case Operation::kAdd:
      return "Add";
    case Operation::kSubtract:
      return "Sub";
    case Operation::kMultiply:
      return "Mul";
    case Operation::kDivide:
      return "Div";
    case Operation::kNegate:
      return "Neg";
    case Operation::kAbsolute:
      return "Abs";
    case Operation::kRoot:
      return "Root";
    case Operation::kWiden:
      return "Wide";
    case Operation::kChoose:
      return "Choose";
    case Operation::kVariable:
    case Operation::kConstant:
      break;
  }
  throw std::logic_error("no operation");
}

const char* text_of(const geometry::MaybeSign& sign) {
  if (!sign) return "None";
  if (*sign == geometry::Sign::kZero) return "(Some Zero)";
  return *sign == geometry::Sign::kPositive ? "(Some Positive)" : "(Some Negative)";
}

// m 2^k with an odd m, or 0.
struct OddNumber {
  std::int64_t m;
  int k;
};
OddNumber odd_number(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a constant has to be finite");
  if (value == 0) return {0, 0};
  int exponent = 0;
  auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; m % 2 == 0; m /= 2) ++exponent;
  return {m, exponent};
}

std::string integer_text(std::int64_t value) { return in(value < 0, std::to_string(value)); }

// Where a line has to be broken, the next one is indented.
std::string in_lines(const std::string& text) {
  std::string result, line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    if (!line.empty() && line.size() + 1 + word.size() > kColumns) {
      result += line + '\n';
      line = "  " + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    start = end + 1;
  }
  return result + line + '\n';
}

void add_terms(const Tree& tree, std::vector<TermNumber>& terms) {
  if (tree.is_leaf()) {
    if (const auto* term = std::get_if<TermNumber>(&tree.answer)) terms.push_back(*term);
    return;
  }
  terms.push_back(tree.comparison.left);
  terms.push_back(tree.comparison.right);
  add_terms(*tree.yes, terms);
  add_terms(*tree.no, terms);
}

bool is_plain(const Term& term) {
  return term.operation == Operation::kVariable || term.operation == Operation::kConstant;
}

}  // namespace

std::string coq_pair(double value) {
  const OddNumber odd = odd_number(value);
  return fmt::format("({}, {})%Z", odd.m, odd.k);
}

void CoqModule::count(TermNumber term, std::map<TermNumber, std::size_t>& uses) const {
  if (is_plain(Terms::at(term)) || names_.contains(term)) return;
  if (++uses[term] > 1) return;
  for (const TermNumber operand : Terms::at(term).operands) count(operand, uses);
}

// Operands come first, from left to right: the order does not depend on that in which a compiler evaluates them.
void CoqModule::define_shared(TermNumber term, const std::map<TermNumber, std::size_t>& uses) {
  if (is_plain(Terms::at(term)) || names_.contains(term)) return;
  for (const TermNumber operand : Terms::at(term).operands) define_shared(operand, uses);
  if (uses.at(term) < 2) return;
  std::string name = fmt::format("x{}", names_.size());
  define_text(name, text_of(term, false));
  names_.emplace(term, std::move(name));
}

void CoqModule::define_shared(std::span<const TermNumber> roots) {
  std::map<TermNumber, std::size_t> uses;
  for (const TermNumber root : roots) count(root, uses);
  for (const TermNumber root : roots) define_shared(root, uses);
}

void CoqModule::define_text(const std::string& name, const std::string& text) {
  body_ += in_lines(fmt::format("Definition {} := {}.", name, text));
}

void CoqModule::define(std::span<const Named> terms) {
  std::vector<TermNumber> roots;
  for (const Named& named : terms) roots.push_back(named.term);
  define_shared(roots);
  for (const auto& [name, term] : terms) define_text(name, text_of(term, false));
}

void CoqModule::define(const std::string& name, const Tree& tree) {
  std::vector<TermNumber> roots;
  add_terms(tree, roots);
  define_shared(roots);
  define_text(name, tree_text(tree, false));
}

std::string CoqModule::tree_text(const Tree& tree, bool in_brackets) const {
  if (tree.is_leaf()) {
    const auto* term = std::get_if<TermNumber>(&tree.answer);
    const std::string answer = term ? text_of(*term, true) : proofs::text_of(std::get<0>(tree.answer));
    return in(in_brackets, "Answer " + answer);
  }
  const auto [relation, left, right] = tree.comparison;
  return in(in_brackets, fmt::format("If {} {} {} {} {}", proofs::text_of(relation), text_of(left, true),
                                     text_of(right, true), tree_text(*tree.yes, true), tree_text(*tree.no, true)));
}

std::string CoqModule::text_of(TermNumber term, bool in_brackets) const {
  if (const auto named = names_.find(term); named != names_.end()) return named->second;
  return in(in_brackets, operation_text(Terms::at(term)));
}

std::string CoqModule::operation_text(const Term& term) const {
  if (term.operation == Operation::kVariable) return fmt::format("Var {}", term.variable);
  if (term.operation == Operation::kConstant) {
    if (std::isinf(term.constant) && term.constant > 0) return "Infinite";
    const OddNumber odd = odd_number(term.constant);
    return fmt::format("Cst {} {}", integer_text(odd.m), integer_text(odd.k));
  }
  std::string text = proofs::text_of(term.operation);
  if (term.operation == Operation::kChoose) text += std::string(" ") + proofs::text_of(term.relation);
  for (const TermNumber operand : term.operands) text += " " + text_of(operand, true);
  return text;
}

std::string CoqModule::text() const { return fmt::format("Module {0}.\n{1}End {0}.\n", name_, body_); }

}  // namespace flowcert::proofs
