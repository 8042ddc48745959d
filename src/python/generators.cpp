// The generators are part of fuzz/, and this file alone sees them.
#include "generators.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <string>

#include "arrays.h"
#include "fuzz/inputs/case_stream.h"
#include "geometry/floating_point.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

py::dict families() {
  py::dict descriptions;
  for (const fuzz::Family& family : fuzz::families()) {
    descriptions[py::str(family.name)] = family.description;
  }
  return descriptions;
}

// A case of `flowcert generate` with one family.
py::array generate(const std::string& family, std::uint64_t seed, int level, std::size_t number) {
  if (level < 1 || level > fuzz::kCaseLevels) throw InvalidInput("level must be 1, 2 or 3");
  if (number >= fuzz::kMostCases) throw InvalidInput("case must be below " + std::to_string(fuzz::kMostCases));
  const fuzz::CaseRun run{
      .level = level, .seed = seed, .cases = fuzz::kMostCases, .chosen = fuzz::chosen_families({family})};
  fuzz::Input input;
  {
    const ReleasedLock released;
    input = fuzz::input_of_case(run, number);
  }
  return rows_of<double>(std::move(input.rows));
}

}  // namespace

void add_generators(py::module_& module) {
  module.def("families", families, "What flowcert.families asks.");
  module.def("generate", generate, py::arg("family"), py::arg("seed"), py::arg("level"), py::arg("number"),
             py::call_guard<geometry::IeeeDoubles>(), "What flowcert.generate asks.");
}

}  // namespace flowcert::python
