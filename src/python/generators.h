// What flowcert.generate and flowcert.families ask.
#pragma once

#include <pybind11/pybind11.h>

namespace flowcert::python {

void add_generators(pybind11::module_& module);

}  // namespace flowcert::python
