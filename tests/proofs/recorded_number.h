// A number that writes down what is computed with it. The templates of src/ over a number type, called with this one,
// give the terms that spec/proofs/ is about.
//
// Guarantees: a term is what C++ computes with the same template and another number type: each operation, its operands
// in their order, and each constant exactly. Equal terms are one. A comparison gives a RecordedTruth. Where it is asked
// for as a bool, recorded_function.h has both answers tried; where it is selected by, both values are in the term.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/vector3.h"

namespace flowcert::proofs {

enum class Operation : std::uint8_t {
  kVariable,
  kConstant,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kNegate,
  kAbsolute,
  kRoot,
  kWiden,  // to the type in which products of products are formed
  kChoose,
};
enum class Relation : std::uint8_t { kLess, kLessEqual, kEqual };

using TermNumber = std::size_t;

struct Term {
  Operation operation = Operation::kConstant;
  Relation relation = Relation::kLess;  // kChoose: between the first two operands
  std::size_t variable = 0;             // kVariable
  double constant = 0;                  // kConstant
  std::vector<TermNumber> operands;

  auto operator<=>(const Term&) const = default;
};

// All terms of the program. An operand has a smaller number than what is made of it.
class Terms {
 public:
  static TermNumber number_of(const Term& term) {
    const auto [place, is_new] = numbers().try_emplace(term, all().size());
    if (is_new) all().push_back(term);
    return place->second;
  }
  static const Term& at(TermNumber number) { return all()[number]; }

 private:
  static std::vector<Term>& all() {
    static std::vector<Term> terms;
    return terms;
  }
  static std::map<Term, TermNumber>& numbers() {
    static std::map<Term, TermNumber> numbers;
    return numbers;
  }
};

struct Comparison {
  Relation relation;
  TermNumber left, right;

  auto operator<=>(const Comparison&) const = default;
};

// The path that a recorded function takes: what each comparison answers that it asks for as a bool.
class Path {
 public:
  static bool answer(const Comparison& comparison) {
    Path& path = current();
    for (std::size_t k = 0; k < path.asked_.size(); ++k) {
      if (path.asked_[k] == comparison) return path.answers_[k];
    }
    path.asked_.push_back(comparison);
    if (path.answers_.size() < path.asked_.size()) path.answers_.push_back(true);
    return path.answers_[path.asked_.size() - 1];
  }
  static void begin(std::vector<bool> answers) { current() = {std::move(answers), {}}; }
  static const std::vector<Comparison>& asked() { return current().asked_; }

 private:
  Path() = default;
  Path(std::vector<bool> answers, std::vector<Comparison> asked)
      : answers_(std::move(answers)), asked_(std::move(asked)) {}
  static Path& current() {
    static Path path;
    return path;
  }

  std::vector<bool> answers_;
  std::vector<Comparison> asked_;
};

// One comparison, or several that are all asked for, or one of which is.
class RecordedTruth {
 public:
  RecordedTruth() = default;  // false: no number is less than itself
  explicit RecordedTruth(const Comparison& comparison) : comparison_(comparison) {}

  explicit operator bool() const {
    switch (kind_) {
      case Kind::kBoth:
        return bool(parts_[0]) && bool(parts_[1]);
      case Kind::kEither:
        return bool(parts_[0]) || bool(parts_[1]);
      case Kind::kOne:
        break;
    }
    return Path::answer(comparison_);
  }
  friend RecordedTruth operator&(const RecordedTruth& a, const RecordedTruth& b) { return {Kind::kBoth, a, b}; }
  // As condition.h has them of doubles.
  friend RecordedTruth condition(const RecordedTruth& truth) { return truth; }
  friend RecordedTruth operator|(const RecordedTruth& a, const RecordedTruth& b) { return {Kind::kEither, a, b}; }

  // The term that is `yes` where this is true, and else `no`.
  [[nodiscard]] TermNumber choice(TermNumber yes, TermNumber no) const {
    switch (kind_) {
      case Kind::kBoth:
        return parts_[0].choice(parts_[1].choice(yes, no), no);
      case Kind::kEither:
        return parts_[0].choice(yes, parts_[1].choice(yes, no));
      case Kind::kOne:
        break;
    }
    return Terms::number_of(
        {Operation::kChoose, comparison_.relation, 0, 0, {comparison_.left, comparison_.right, yes, no}});
  }

 private:
  enum class Kind : std::uint8_t { kOne, kBoth, kEither };
  RecordedTruth(Kind kind, const RecordedTruth& a, const RecordedTruth& b) : kind_(kind), parts_{a, b} {}

  Kind kind_ = Kind::kOne;
  Comparison comparison_{Relation::kLess, 0, 0};
  std::vector<RecordedTruth> parts_;
};

// Doubles are never widened. Integers are kNarrow, or kWide where products of products are formed.
enum class Width : std::uint8_t { kDouble, kNarrow, kWide };

template <Width width>
class Recorded {
 public:
  Recorded() : Recorded(0.0) {}
  Recorded(double constant)  // NOLINT: numbers mix with constants
      : term_(Terms::number_of({Operation::kConstant, {}, 0, constant, {}})) {}
  template <Width other>
    requires(width == Width::kWide && other == Width::kNarrow)
  explicit Recorded(const Recorded<other>& narrow)
      : term_(Terms::number_of({Operation::kWiden, {}, 0, 0, {narrow.term()}})) {}
  [[nodiscard]] static Recorded variable(std::size_t number) {
    return Recorded(Term{Operation::kVariable, {}, number, 0, {}});
  }

  [[nodiscard]] TermNumber term() const { return term_; }

  Recorded operator-() const { return of(Operation::kNegate, *this); }
  friend Recorded operator+(const Recorded& a, const Recorded& b) { return of(Operation::kAdd, a, b); }
  friend Recorded operator-(const Recorded& a, const Recorded& b) { return of(Operation::kSubtract, a, b); }
  friend Recorded operator*(const Recorded& a, const Recorded& b) { return of(Operation::kMultiply, a, b); }
  friend Recorded operator/(const Recorded& a, const Recorded& b) { return of(Operation::kDivide, a, b); }
  friend Recorded sqrt(const Recorded& a) { return of(Operation::kRoot, a); }
  friend Recorded select(const RecordedTruth& is_true, const Recorded& yes, const Recorded& no) {
    return Recorded(is_true.choice(yes.term_, no.term_), 0);
  }
  friend Recorded absolute(const Recorded& a) { return of(Operation::kAbsolute, a); }

  friend RecordedTruth operator<(const Recorded& a, const Recorded& b) { return compare(Relation::kLess, a, b); }
  friend RecordedTruth operator>(const Recorded& a, const Recorded& b) { return b < a; }
  friend RecordedTruth operator<=(const Recorded& a, const Recorded& b) { return compare(Relation::kLessEqual, a, b); }
  friend RecordedTruth operator>=(const Recorded& a, const Recorded& b) { return b <= a; }
  friend RecordedTruth operator==(const Recorded& a, const Recorded& b) { return compare(Relation::kEqual, a, b); }

 private:
  Recorded(TermNumber term, int) : term_(term) {}
  explicit Recorded(const Term& term) : term_(Terms::number_of(term)) {}
  static Recorded of(Operation operation, const auto&... operands) {
    return Recorded(Term{operation, {}, 0, 0, {operands.term()...}});
  }
  static RecordedTruth compare(Relation relation, const Recorded& a, const Recorded& b) {
    return RecordedTruth({relation, a.term(), b.term()});
  }

  TermNumber term_;
};

using RecordedDouble = Recorded<Width::kDouble>;
using RecordedInteger = Recorded<Width::kNarrow>;

// Point `number` of a query: its coordinates are the variables 3 number, 3 number + 1 and 3 number + 2.
template <Width width>
[[nodiscard]] geometry::Vector3<Recorded<width>> recorded_vector(std::size_t number) {
  using Number = Recorded<width>;
  return {Number::variable(3 * number), Number::variable(3 * number + 1), Number::variable(3 * number + 2)};
}

}  // namespace flowcert::proofs

namespace flowcert::geometry {

template <>
struct Promoted<proofs::RecordedInteger> {
  using Type = proofs::Recorded<proofs::Width::kWide>;
};

}  // namespace flowcert::geometry
