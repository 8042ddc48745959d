// The complex for other programs: the data of the exports as arrays, and the viewer's page.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "complex.h"
#include "flowcert/surface.h"
#include "io/pocket_persistence.h"
#include "io/region_exports.h"
#include "io/unstable_surface_export.h"
#include "io/viewer_page.h"
#include "io/vtk_exports.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

using DataSet = std::variant<PolyData, UnstructuredGrid>;

void ask(std::size_t, std::size_t) { stop_if_interrupted(); }

DataSet data_set(const FlowComplex& complex, const std::string& name, const std::vector<std::string>& selection,
                 const std::optional<ClipBox>& box) {
  if (name == "critical_points") return critical_point_data(complex, ask);
  if (name == "stable_surfaces") {
    return stable_surface_data(complex, surface_mesh(complex, selected_sets(complex, selection), ask));
  }
  if (name == "unstable_lines") return unstable_line_data(complex, box, ask);
  if (name == "unstable_fans") return unstable_fan_data(complex);
  if (name == "unstable_surfaces") {
    return UnstableSurfaceExport(complex, box, std::filesystem::temp_directory_path().string(), ask).data();
  }
  if (name == "stable_cells") return stable_cell_data(complex);
  if (name == "infinity_cells") return infinity_cell_data(complex, box);
  throw InvalidInput(fmt::format("there is no export {}", name));
}

// {name: array}, each with a row of several numbers where it has several components.
py::dict arrays_of(std::vector<VtpArray> arrays) {
  py::dict made;
  for (VtpArray& array : arrays) {
    made[py::str(array.name)] = std::visit(
        [&](auto& values) -> py::array {
          using Number = typename std::decay_t<decltype(values)>::value_type;
          const auto size = static_cast<py::ssize_t>(values.size());
          if (array.components == 1) return array_of<Number>(std::move(values), {size});
          return array_of<Number>(std::move(values), {size / array.components, array.components});
        },
        array.values);
  }
  return made;
}

py::tuple cells_of(VtpCells cells) {
  return py::make_tuple(array_of(std::move(cells.connectivity)), array_of(std::move(cells.offsets)));
}

py::tuple tuple_of(PolyData data) {
  const py::tuple cells = py::make_tuple(cells_of(std::move(data.vertices)), cells_of(std::move(data.lines)),
                                         cells_of(std::move(data.polygons)));
  return py::make_tuple(rows_of<double>(std::move(data.points)), cells, py::none(),
                        arrays_of(std::move(data.point_data)), arrays_of(std::move(data.cell_data)));
}

py::tuple tuple_of(UnstructuredGrid data) {
  const auto size = static_cast<py::ssize_t>(data.shapes.size());
  return py::make_tuple(rows_of<double>(std::move(data.points)), py::make_tuple(cells_of(std::move(data.cells))),
                        array_of<std::uint8_t>(std::move(data.shapes), {size}), py::dict(),
                        arrays_of(std::move(data.cell_data)));
}

}  // namespace

py::tuple Complex::exported(const std::string& name, const std::vector<std::string>& selection,
                            const std::optional<std::string>& clip) const {
  std::optional<DataSet> data;
  {
    const ReleasedLock released;
    std::optional<ClipBox> box;
    if (clip && !complex_.points().empty()) box.emplace(complex_.points(), rational_of(*clip));
    data = data_set(complex_, name, selection, box);
  }
  return std::visit([](auto& each) { return tuple_of(std::move(each)); }, *data);
}

py::bytes Complex::page(const std::string& name, const std::vector<AtomTexts>& atoms, std::size_t most, bool has_cells,
                        const std::optional<std::string>& pockets) const {
  std::ostringstream out;
  {
    const ReleasedLock released;
    const AtomNames names = atom_names(atoms, row_count());
    std::optional<Pockets> made;
    if (pockets) made.emplace(complex_.merge_trees(), pocket_persistence(complex_, *pockets, "pockets").square);
    ViewerOptions options{.name = name, .most_of_an_index = most, .has_cells = has_cells};
    if (!names.empty()) options.atoms = &names;
    if (made) options.pockets = &*made;
    write_viewer_page(out, complex_, options, ask);
  }
  return py::bytes(std::move(out).str());
}

}  // namespace flowcert::python
