// The module flowcert._core. What users see is in the package's Python files; this has what these ask.
//
// Guarantees: what the library calls invalid input is Python's ValueError, with the program's one line.
#include <pybind11/pybind11.h>

#include <string_view>

#include "atoms.h"
#include "check.h"
#include "complex.h"
#include "flowcert/reproducibility.h"
#include "generators.h"
#include "geometry/floating_point.h"
#include "geometry/gmp_memory.h"
#include "numbers.h"
#include "point_files.h"
#include "pores.h"

PYBIND11_MODULE(_core, module) {
  namespace python = flowcert::python;
  flowcert::geometry::let_gmp_fail_as_new_does();
  module.doc() = "What the package flowcert asks of the library. Use flowcert itself.";
  // pybind11 wants a function of exactly this type.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  pybind11::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const flowcert::InvalidInput& error) {
      // A message may quote an input or a file's name, which may have other bytes than UTF-8.
      const std::string_view what(error.what());
      const auto message = pybind11::reinterpret_steal<pybind11::object>(
          PyUnicode_DecodeUTF8(what.data(), static_cast<pybind11::ssize_t>(what.size()), "replace"));
      if (message) PyErr_SetObject(PyExc_ValueError, message.ptr());
    }
  });
  const flowcert::Reproducibility made_by = flowcert::reproducibility();
  module.attr("version") = made_by.version;
  module.attr("made_by") = "flowcert " + made_by.version + " (commit " + made_by.commit +
                           "; kernel: " + made_by.kernel + "; compiler: " + made_by.compiler + "; CGAL " +
                           made_by.cgal + ")";
  module.def(
      "in_ieee_doubles",
      [](const pybind11::function& function, const pybind11::args& arguments) { return function(*arguments); },
      pybind11::arg("function"), pybind11::call_guard<flowcert::geometry::IeeeDoubles>(),
      "Calls the function with doubles as IEEE 754 says, whatever modes another library has set.");
  module.def("decimal_text", python::decimal_text, pybind11::arg("hexadecimal"), "A fraction in decimals.");
  python::add_atoms(module);
  python::add_complex(module);
  python::add_check(module);
  python::add_generators(module);
  python::add_point_files(module);
  python::add_pores(module);
}
