// Terms as a module of Coq (spec/proofs/code/Expression.v says what they mean).
//
// Guarantees: constants are exact. A term that several others are made of is defined once, under a name of its own,
// before them. Lines have at most 120 columns.
#pragma once

#include <map>
#include <span>
#include <string>
#include <variant>

#include "geometry/vector3.h"
#include "tests/proofs/recorded_function.h"
#include "tests/proofs/recorded_number.h"

namespace flowcert::proofs {

// A double as "(m, k)", which is m 2^k with an odd m, or 0.
[[nodiscard]] std::string coq_pair(double value);

// What a leaf of a tree has.
using CoqAnswer = std::variant<geometry::MaybeSign, TermNumber>;

class CoqModule {
 public:
  explicit CoqModule(std::string name) : name_(std::move(name)) {}

  // Each term becomes a definition. Terms that they share come before them.
  struct Named {
    std::string name;
    TermNumber term;
  };
  void define(std::span<const Named> terms);
  void define(const std::string& name, const DecisionTree<CoqAnswer>& tree);

  [[nodiscard]] std::string text() const;

 private:
  void count(TermNumber term, std::map<TermNumber, std::size_t>& uses) const;
  // Names what several terms are made of.
  void define_shared(std::span<const TermNumber> roots);
  void define_shared(TermNumber term, const std::map<TermNumber, std::size_t>& uses);
  void define_text(const std::string& name, const std::string& text);
  // In brackets where an operand needs them.
  [[nodiscard]] std::string text_of(TermNumber term, bool in_brackets) const;
  [[nodiscard]] std::string operation_text(const Term& term) const;
  [[nodiscard]] std::string tree_text(const DecisionTree<CoqAnswer>& tree, bool in_brackets) const;

  std::string name_, body_;
  std::map<TermNumber, std::string> names_;
};

}  // namespace flowcert::proofs
