// What flowcert.read_points and flowcert.read_balls ask.
#pragma once

#include <pybind11/pybind11.h>

namespace flowcert::python {

void add_point_files(pybind11::module_& module);

}  // namespace flowcert::python
