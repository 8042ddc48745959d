#include "atoms.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "flowcert/atom_radii.h"
#include "geometry/floating_point.h"
#include "io/elements.h"
#include "numbers.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// Pairs of ints; None for an element that has none among these radii.
py::list element_radii(const std::vector<std::string>& elements, const std::string& radii) {
  const AtomRadii said(radii);
  py::list found;
  for (const std::string& element : elements) {
    const bool is_one = said.source() == AtomRadii::Source::kOne;
    const Rational* radius = said.of_element(io::symbol_of(element));
    if (radius == nullptr && is_one) radius = &said.one();
    found.append(radius == nullptr ? py::object(py::none()) : ratio_of(*radius));
  }
  return found;
}

}  // namespace

AtomNames atom_names(const std::vector<AtomTexts>& atoms, std::size_t rows) {
  AtomNames names;
  if (!atoms.empty() && atoms.size() != rows) {
    throw InvalidInput(fmt::format("atoms must be one for each of {} points, not {}", rows, atoms.size()));
  }
  for (const auto& [chain, residue, number, atom, element] : atoms) {
    names.add({.chain = chain, .residue = residue, .number = number, .atom = atom, .element = element});
  }
  return names;
}

void add_atoms(py::module_& module) {
  module.def("element_radii", element_radii, py::arg("elements"), py::arg("radii"),
             py::call_guard<geometry::IeeeDoubles>(), "The radii of elements as --radii says them.");
}

}  // namespace flowcert::python
