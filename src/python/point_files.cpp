#include "point_files.h"

#include <string>

#include "arrays.h"
#include "flowcert/read_points.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

py::array rows_of_file(const std::string& path) {
  PointFile file;
  {
    const ReleasedLock released;
    file = read_points(path);
  }
  py::array rows = rows_of<double>(std::move(file.rows));
  rows.attr("setflags")(py::arg("write") = true);  // nobody else has it
  return rows;
}

}  // namespace

void add_point_files(py::module_& module) {
  module.def("read_points", rows_of_file, py::arg("path"), "What flowcert.read_points asks.");
}

}  // namespace flowcert::python
