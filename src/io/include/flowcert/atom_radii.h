// The radii of atoms as a user says them: --radii bondi,Fe=2.04.
//
// Guarantees: a radius is the number that is written, and above 0; nothing is rounded. Lengths have the unit of the
// points; those of the two tables by element are in ångströms. Source: spec clause FC-FILE-55.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "flowcert/rational.h"

namespace flowcert {

class AtomRadii {
 public:
  // Where the radius of an atom is, unless an override for its element has it: in a table by elements; in its line of a
  // PQR file; in a column of a table; or it is one radius for all.
  enum class Source { kElements, kPqr, kColumn, kOne };

  // `text` is one of
  //   bondi, alvarez   the table of this name
  //   pqr              the file's own radii
  //   column:N         the N-th column of a table, from 1
  //   table:FILE       FILE has lines ELEMENT RADIUS; it is read here
  //   R                a number: a decimal, a fraction p/q or a hexadecimal float
  // and behind it any number of overrides ",Fe=2.04". Symbols are written as in the periodic table; D and T are H.
  // Throws InvalidInput: "--radii:K: reason", where K counts the parts between commas from 1, or "FILE:LINE: reason".
  explicit AtomRadii(std::string_view text);

  // As the user has it.
  [[nodiscard]] const std::string& text() const { return text_; }
  // The same without overrides.
  [[nodiscard]] const std::string& base() const { return base_; }

  [[nodiscard]] Source source() const { return source_; }
  [[nodiscard]] std::size_t column() const { return column_; }
  [[nodiscard]] const Rational& one() const { return one_; }
  // Whether the file has to say elements: for a table by elements, and for overrides.
  [[nodiscard]] bool needs_elements() const { return source_ == Source::kElements || !by_element_.empty(); }
  // That of a table by elements, or of an override; null where there is none.
  [[nodiscard]] const Rational* of_element(std::string_view symbol) const;

 private:
  void read_base();
  void read_table(const std::string& path);

  std::string text_, base_;
  Source source_ = Source::kElements;
  std::size_t column_ = 0;
  Rational one_ = 0;
  std::map<std::string, Rational, std::less<>> by_element_;
};

}  // namespace flowcert
