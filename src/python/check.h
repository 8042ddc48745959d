// What flowcert.check asks.
#pragma once

#include <pybind11/pybind11.h>

namespace flowcert::python {

void add_check(pybind11::module_& module);

}  // namespace flowcert::python
