// Pockets for Python, and where many positions flow to.
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "complex.h"
#include "flowcert/pockets.h"
#include "flowcert/sphere.h"
#include "flowcert/stable_manifolds.h"
#include "io/pocket_persistence.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// What a pocket has beside its places.
struct PocketNumbers {
  Rational difference_of_squares;
  double depth = 0, volume = 0;
  std::vector<double> areas;
  std::vector<PointId> lining;
  std::optional<Passage> passage;
};

PocketNumbers numbers_of(const FlowComplex& complex, const Pockets& pockets, const Pocket& pocket,
                         const std::optional<Rational>& probe) {
  const auto& counts = complex.stationary().critical_counts();
  PocketNumbers numbers{pockets.difference_of_squares(pocket),      pockets.depth(pocket),
                        complex.volumes().nearest_sum(pocket.cell), {},
                        Pockets::lining(pocket, complex.volumes()), {}};
  for (const std::uint32_t mouth : pocket.mouths) {
    numbers.areas.push_back(surface_area(complex.points(), complex.stable(), mouth - counts[0] - counts[1]));
  }
  if (probe) numbers.passage = pockets.passage(pocket, *probe * *probe);
  return numbers;
}

py::tuple tuple_of_pocket(const Pockets& pockets, const Pocket& pocket, PocketNumbers numbers) {
  std::vector<std::int64_t> neighbours(pocket.neighbours.begin(), pocket.neighbours.end());
  const auto outside = static_cast<std::int64_t>(pockets.size());
  std::ranges::replace(neighbours, outside, std::int64_t{-1});
  const py::object passage = numbers.passage ? py::object(py::str(passage_text(*numbers.passage))) : py::none();
  return py::make_tuple(places_of(pocket.peaks), places_of(pocket.maxima), numbers.depth,
                        ratio_of(numbers.difference_of_squares), numbers.volume, places_of(pocket.cell),
                        places_of(pocket.mouths), array_of(std::move(numbers.areas)), array_of(std::move(neighbours)),
                        places_of(pocket.to_infinity.gates), places_of(numbers.lining), passage);
}

}  // namespace

py::tuple Complex::pockets(const std::string& persistence, const std::optional<std::string>& probe) const {
  std::optional<Pockets> made;
  std::vector<PocketNumbers> numbers;
  {
    const ReleasedLock released;
    made.emplace(complex_.merge_trees(), pocket_persistence(complex_, persistence, "persistence").square);
    const std::optional<Rational> radius = probe ? std::optional(rational_of(*probe)) : std::nullopt;
    for (std::size_t k = 0; k < made->size(); ++k) {
      numbers.push_back(numbers_of(complex_, *made, (*made)[k], radius));
    }
  }
  py::list pockets;
  for (std::size_t k = 0; k < made->size(); ++k) {
    pockets.append(tuple_of_pocket(*made, (*made)[k], std::move(numbers[k])));
  }
  const std::optional<WidestPath> widest = made->widest_path();
  return py::make_tuple(pockets, places_of(made->outside()), places_of(widest ? widest->gates : WidestPath{}.gates),
                        places_of(made->largest_balls()), ratio_of(made->squared_persistence()));
}

py::tuple Complex::locate(const PointRows& rows) const {
  const std::span<const Point> positions = points_of(rows);
  std::vector<std::int64_t> limits, nearest;
  std::vector<bool> is_tied;
  {
    const ReleasedLock released;
    if (complex_.points().empty()) throw InvalidInput("there are no points");
    limits.reserve(positions.size());
    for (const Point& x : positions) {
      const FlowPlace place = complex_.locate(x);
      limits.push_back(place.limit ? static_cast<std::int64_t>(*place.limit) : -1);
      nearest.push_back(static_cast<std::int64_t>(place.nearest.front()));
      is_tied.push_back(place.nearest.size() > 1);
    }
  }
  py::array_t<bool> tied(static_cast<py::ssize_t>(is_tied.size()));
  std::copy(is_tied.begin(), is_tied.end(), tied.mutable_data());
  return py::make_tuple(array_of(std::move(limits)), array_of(std::move(nearest)), tied);
}

}  // namespace flowcert::python
