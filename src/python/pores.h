// What flowcert.pores and FlowComplex.pockets with radii ask.
#pragma once

#include <pybind11/pybind11.h>

namespace flowcert::python {

void add_pores(pybind11::module_& module);

}  // namespace flowcert::python
