// Conditions as numbers, because && is a branch to the compiler, and loops over lanes must have none.
//
// A number type other than double may have conditions of its own: a type with & and |, and with these functions
// (tests/proofs/recorded_number.h).
#pragma once

namespace flowcert::geometry {

[[nodiscard, gnu::always_inline]] inline int condition(bool is_true) { return static_cast<int>(is_true); }
[[nodiscard, gnu::always_inline]] inline double select(int is_true, double yes, double no) {
  return is_true != 0 ? yes : no;
}
// Longer floating-point types are chosen from in the same way.
template <class Number>
[[nodiscard]] Number select(int is_true, const Number& yes, const Number& no) {
  return is_true != 0 ? yes : no;
}
// std::min() and std::max() are branches to the compiler, because they return references.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number least(const Number& x, const Number& y) {
  return select(condition(y < x), y, x);
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number most(const Number& x, const Number& y) {
  return select(condition(x < y), y, x);
}

template <class Number>
using Condition = decltype(condition(Number() < Number()));

}  // namespace flowcert::geometry
