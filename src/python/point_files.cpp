#include "point_files.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "flowcert/read_balls.h"
#include "geometry/floating_point.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// (chain, residue, number, atom, element) of each row.
py::list names_of(const AtomNames& atoms) {
  const auto text = [](std::string_view field) { return py::str(field.data(), field.size()); };
  py::list names;
  for (PointId row = 0; row < atoms.size(); ++row) {
    const AtomName name = atoms[row];
    names.append(
        py::make_tuple(text(name.chain), text(name.residue), text(name.number), text(name.atom), text(name.element)));
  }
  return names;
}

// The points, the notes as (line, text), the rows that are left out, the names of a molecule's atoms if they are asked
// for, and with radii the balls as (centre, radius).
py::tuple read_file(const std::string& path, const ReadingOptions& options, bool with_atoms,
                    const std::optional<std::string>& radii) {
  BallFile read;
  {
    const ReleasedLock released;
    if (radii) read = read_balls(path, options, AtomRadii(*radii));
    if (!radii) read.file = read_points(path, options);
  }
  PointFile& file = read.file;
  py::list notes, balls;
  for (const ReadingNote& note : file.notes) notes.append(py::make_tuple(note.line, note.text));
  for (const Ball& ball : read.balls) balls.append(py::make_tuple(ratios_of(ball.center), ratio_of(ball.radius)));
  const py::list names = with_atoms ? names_of(file.atoms) : py::list();
  return py::make_tuple(rows_of<double>(std::move(file.rows)), notes, py::cast(file.left_out), names, balls);
}

}  // namespace

void add_point_files(py::module_& module) {
  module.def(
      "read_points",
      [](const std::string& path, std::string format, std::string columns, std::optional<double> z,
         std::vector<std::string> atoms, std::vector<std::string> chains, std::string models, std::size_t frame,
         bool skip_invalid, bool unlimited, bool finite, bool with_atoms, const std::optional<std::string>& radii) {
        return read_file(path,
                         {.format = std::move(format),
                          .columns = std::move(columns),
                          .z = z,
                          .chains = std::move(chains),
                          .atoms = std::move(atoms),
                          .models = std::move(models),
                          .frame = frame,
                          .skip_invalid = skip_invalid,
                          .unlimited = unlimited,
                          .finite = finite,
                          .progress = stop_if_interrupted},
                         with_atoms, radii);
      },
      py::arg("path"), py::arg("format"), py::arg("columns"), py::arg("z"), py::arg("atoms"), py::arg("chains"),
      py::arg("models"), py::arg("frame"), py::arg("skip_invalid"), py::arg("unlimited"), py::arg("finite"),
      py::arg("with_atoms"), py::arg("radii"), py::call_guard<geometry::IeeeDoubles>(),
      "What flowcert.read_points and flowcert.read_balls ask.");
}

}  // namespace flowcert::python
