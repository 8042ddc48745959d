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
  return rows_of<double>(std::move(file.rows));
}

}  // namespace

void add_point_files(py::module_& module) {
  module.def("read_points", rows_of_file, py::arg("path"), "What flowcert.read_points asks.");
}

}  // namespace flowcert::python
