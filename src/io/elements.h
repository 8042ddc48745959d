// Chemical elements, with two tables of their van der Waals radii, and which element a file's text means.
//
// Guarantees: D and T are H. A text that may mean two elements is said to mean both, so that nobody takes one for the
// other. Source: spec clause FC-FILE-55.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// Radii in hundredths of an ångström; 0 where a table has none.
//
// bondi: A. Bondi, J. Phys. Chem. 68 (1964) 441, and, for elements that he has not, M. Mantina et al., J. Phys. Chem. A
// 113 (2009) 5806; as in ase.data.vdw.
// alvarez: S. Alvarez, Dalton Trans. 42 (2013) 8617; as in ase.data.vdw_alvarez.
struct Element {
  std::string_view symbol;
  std::uint16_t bondi = 0, alvarez = 0;
};

// In the order of their atomic numbers, hydrogen first.
[[nodiscard]] std::span<const Element> elements();

// The symbol as the periodic table has it, of letters as "Fe", "FE" or "D"; empty where they are no element's.
[[nodiscard]] std::string_view symbol_of(std::string_view letters);

enum class ElementSource {
  kSymbol,   // what a file has for the element: "Fe", "FE", "Fe3+"
  kLabel,    // an element with or without more behind it, or an atomic number: "C12", "6"
  kPdbName,  // the name of an atom in columns 13 to 16, with its blanks
  kName,     // the same without its blanks
};
struct ElementText {
  std::string_view text{};
  ElementSource source = ElementSource::kSymbol;
};

// Empty where the text is no element's. other: what it may mean as well.
struct MeantElement {
  std::string_view symbol{}, other{};
};
// residue: of the atom, where it has one.
[[nodiscard]] MeantElement element_of(const ElementText& text, std::string_view residue = {});

}  // namespace flowcert::io
