// Atoms of other libraries: their names and the radii of their elements (flowcert/_molecules.py).
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "flowcert/atom_names.h"

namespace flowcert::python {

// Chain, residue, number, atom and element.
using AtomTexts = std::array<std::string, 5>;

// Throws InvalidInput if there are some, but not one for each row.
[[nodiscard]] AtomNames atom_names(const std::vector<AtomTexts>& atoms, std::size_t rows);

void add_atoms(pybind11::module_& module);

}  // namespace flowcert::python
