// flowcert-proof-terms FOLDER: writes what the templates of src/ compute, and the constants of their headers, as Coq
// (spec/proofs/code/generated/).
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "flow/kernels/crossing_sphere.h"
#include "flow/kernels/direction_bounds.h"
#include "geometry/distance_filter.h"
#include "geometry/double_double.h"
#include "geometry/filter_bounds.h"
#include "geometry/integer_grid.h"
#include "geometry/predicates.h"
#include "geometry/tetrahedron_forms.h"
#include "tests/proofs/coq_module.h"
#include "tests/proofs/direction_terms.h"

namespace flowcert::proofs {

namespace {

using namespace geometry;

// The points of a query, whose places in this list are their numbers in the terms.
constexpr std::array<Point, 5> kPoints{};
constexpr auto& p = kPoints;

std::size_t number_of(const Point& point) { return static_cast<std::size_t>(&point - kPoints.data()); }

// A variable after those of all points.
constexpr std::size_t kExactReachVariable = 15;

// The filter of a query, what it knows on a grid, and its polynomial in integers. There, vector k has the variables of
// point k.
template <class Query>
CoqModule module_of(const std::string& name, const Query& query) {
  CoqModule module(name);
  const auto vectors = query.vectors([](const Point& from, const Point& to) {
    return vector_between(recorded_vector<Width::kDouble>(number_of(from)),
                          recorded_vector<Width::kDouble>(number_of(to)));
  });
  module.define("sign", recorded_function([&] { return CoqAnswer(filtered_sign<Query>(vectors)); }));
  const RecordedDouble exact_reach = RecordedDouble::variable(kExactReachVariable);
  module.define("unrounded_sign",
                recorded_function([&] { return CoqAnswer(unrounded_sign<Query>(vectors, exact_reach)); }));
  std::array<Vector3<RecordedInteger>, vectors.size()> integers;
  for (std::size_t k = 0; k < integers.size(); ++k) integers[k] = recorded_vector<Width::kNarrow>(k);
  module.define("integers", recorded_function([&] { return CoqAnswer(Query::value(integers).term()); }));
  return module;
}

// The vectors a, b and c of a cell from its vertex 0 have the variables of points 0, 1 and 2, and that of a sample has
// those of point 3.
template <Width width>
std::array<Vector3<Recorded<width>>, 3> cell_vectors() {
  return {recorded_vector<width>(0), recorded_vector<width>(1), recorded_vector<width>(2)};
}

const CoqAnswer kNoAnswer(std::in_place_index<0>, std::nullopt);

CoqModule cell_module() {
  CoqModule module("Cell");
  const auto [a, b, c] = cell_vectors<Width::kDouble>();
  const RecordedDouble exact_reach = RecordedDouble::variable(kExactReachVariable);
  const CellForms<RecordedDouble> forms = cell_forms(a, b, c, exact_reach);
  std::vector<CoqModule::Named> named;
  for (std::size_t k = 0; k < forms.angles.size(); ++k) {
    named.push_back({fmt::format("angle_{}", k), forms.angles[k].term()});
  }
  for (std::size_t k = 0; k < forms.sides.size(); ++k)
    named.push_back({fmt::format("side_{}", k), forms.sides[k].term()});
  named.push_back({"angle_error", forms.angle_error.term()});
  for (std::size_t k = 0; k < forms.side_errors.size(); ++k) {
    named.push_back({fmt::format("side_error_{}", k), forms.side_errors[k].term()});
  }
  module.define(named);
  // Form and error are variables 0 and 1.
  const RecordedDouble form = RecordedDouble::variable(0), error = RecordedDouble::variable(1);
  const auto certain_sign = [&] {
    if (!is_certain(form, error)) return kNoAnswer;
    return CoqAnswer(MaybeSign(form < 0 ? Sign::kNegative : Sign::kPositive));
  };
  module.define("certain_sign", recorded_function(certain_sign));
  const Vector3<RecordedDouble> v = recorded_vector<Width::kDouble>(3);
  const auto answer = compare_sphere(forms.sphere, v, exact_reach);
  const auto tree_of = [](const RecordedTruth& truth) {
    return recorded_function([&] { return truth ? CoqAnswer(MaybeSign(Sign::kPositive)) : kNoAnswer; });
  };
  module.define("is_cell_exact", tree_of(forms.sphere.is_exact));
  module.define("is_beyond_sphere", tree_of(answer.is_beyond_bound));
  module.define("is_exact", tree_of(answer.is_exact));
  module.define("is_on_sphere", tree_of(answer.is_zero));
  return module;
}

CoqModule cell_integers_module() {
  CoqModule module("CellIntegers");
  const auto [a, b, c] = cell_vectors<Width::kNarrow>();
  const auto angles = cell_angles<RecordedInteger>(dot(a, a), dot(b, b), dot(c, c), dot(a, b), dot(b, c), dot(c, a));
  const auto sides = cell_sides(circumsphere(a, b, c));
  std::vector<CoqModule::Named> named;
  for (std::size_t k = 0; k < angles.size(); ++k) named.push_back({fmt::format("angle_{}", k), angles[k].term()});
  for (std::size_t k = 0; k < sides.size(); ++k) named.push_back({fmt::format("side_{}", k), sides[k].term()});
  module.define(named);
  return module;
}

// The position is point 0, and the sample is point 1. Distance and largest coordinate are variables 0 and 1.
CoqModule distances_module() {
  CoqModule module("Distances");
  const RecordedDouble distance =
      rounded_distance(recorded_vector<Width::kDouble>(0), recorded_vector<Width::kDouble>(1));
  const RecordedDouble reach = reach_of(RecordedDouble::variable(0), RecordedDouble::variable(1));
  module.define(std::vector<CoqModule::Named>{{"distance", distance.term()}, {"reach", reach.term()}});
  return module;
}

// Two doubled numbers have the variables 0 and 1, and 2 and 3: high part and low part. Two doubles have 0 and 1.
CoqModule doubled_module() {
  using Doubled = DoubledNumber<RecordedDouble>;
  CoqModule module("Doubled");
  const RecordedDouble a = RecordedDouble::variable(0), b = RecordedDouble::variable(1);
  const Doubled x = Doubled::of_parts(a, b);
  const Doubled y = Doubled::of_parts(RecordedDouble::variable(2), RecordedDouble::variable(3));
  std::vector<CoqModule::Named> named;
  const auto name = [&](const std::string& operation, const Doubled& result) {
    named.push_back({operation + "_high", result.high().term()});
    named.push_back({operation + "_low", result.low().term()});
  };
  name("sum", Doubled::sum(a, b));
  name("product", Doubled::product(a, b));
  name("plus", x + y);
  name("minus", x - y);
  name("times", x * y);
  name("quotient", x / y);
  module.define(named);
  module.define("root_high", recorded_function([&] { return CoqAnswer(sqrt(x).high().term()); }));
  module.define("root_low", recorded_function([&] { return CoqAnswer(sqrt(x).low().term()); }));
  module.define("absolute_high", recorded_function([&] { return CoqAnswer(abs(x).high().term()); }));
  module.define("absolute_low", recorded_function([&] { return CoqAnswer(abs(x).low().term()); }));
  module.define("is_less",
                recorded_function([&] { return x < y ? CoqAnswer(MaybeSign(Sign::kPositive)) : kNoAnswer; }));
  return module;
}

using namespace flow;

struct Constant {
  const char* name;
  double value;
};
#define CONSTANT(name) \
  Constant { #name, static_cast<double>(name) }
constexpr Constant kConstants[] = {
    CONSTANT(kUnitRoundoff),       CONSTANT(kSmallestNorm),       CONSTANT(kLargestNorm),
    CONSTANT(kAngleBound),         CONSTANT(kOrientationBound),   CONSTANT(kSideOfPlaneBound),
    CONSTANT(kOutsideSphereBound), CONSTANT(kOutsideCircleBound), CONSTANT(kCellAngleBound),
    CONSTANT(kCellSideBound),      CONSTANT(kFarCellSideBound),   CONSTANT(kExactReach),
    CONSTANT(kDistanceBound),      CONSTANT(kPositionBound),      CONSTANT(kDistanceUnderflow),
    CONSTANT(kLargestDistance),    CONSTANT(kWideBits),           CONSTANT(kNarrowBits),
    CONSTANT(kSmallBits),          CONSTANT(kVertexStartBound),   CONSTANT(kCircleStartBound),
    CONSTANT(kSideStartBound),     CONSTANT(kGivenStartBound),    CONSTANT(kCrossingBound),
    CONSTANT(kAngleFormBound),     CONSTANT(kHeightBound),        CONSTANT(kExitBound),
    CONSTANT(kOrderBound),         CONSTANT(kNormalBound),        CONSTANT(kAreaBound),
    CONSTANT(kSmallestSquare),     CONSTANT(kLargestSquare),      CONSTANT(kLargestError),
    CONSTANT(kTangentOfSine),      CONSTANT(kTangentBehind),      CONSTANT(kOrderTurn),
    CONSTANT(kCrossingSlack),      CONSTANT(kCoordinateBound),    {"kDoubledRoundoff", DoubleDouble::kRoundoff}};
#undef CONSTANT

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << "(* Printed by flowcert-proof-terms; not to be edited. *)\n" << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

void write_all(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string constants = "From Coq Require Import ZArith.\n\n(* (m, k) is m 2^k. *)\n";
  for (const auto& [name, value] : kConstants) {
    constants += fmt::format("Definition {} := {}.\n", name, coq_pair(value));
  }
  write(folder / "Constants.v", constants);
  const std::string start = "From Coq Require Import ZArith.\nFrom Flowcert Require Import code.Expression.\n";
  std::string predicates = start;
  predicates += "\n" + module_of("Angle", Angle{p[0], p[1], p[2]}).text();
  predicates += "\n" + module_of("SideOfPlane", SideOfPlane{p[0], p[1], p[2], p[3]}).text();
  predicates += "\n" + module_of("OutsideSphere", OutsideSphere{p[0], p[1], p[2], p[3], p[4]}).text();
  predicates += "\n" + module_of("Orientation", Orientation{p[0], p[1], p[2], p[3]}).text();
  predicates += "\n" + module_of("OutsideCircle", OutsideCircle{p[0], p[1], p[2], p[3]}).text();
  write(folder / "Predicates.v", predicates);
  write(folder / "Distances.v", start + "\n" + distances_module().text());
  std::string directions = start;
  for (const CoqModule& module : direction_modules()) directions += "\n" + module.text();
  write(folder / "Directions.v", directions);
  write(folder / "Doubled.v", start + "\n" + doubled_module().text());
  write(folder / "Cells.v", start + "\n" + cell_module().text() + "\n" + cell_integers_module().text());
}

}  // namespace

}  // namespace flowcert::proofs

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: flowcert-proof-terms FOLDER\n", stderr);
    return 2;
  }
  try {
    flowcert::proofs::write_all(arguments[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "flowcert-proof-terms: {}\n", error.what());
    return 2;
  }
  return 0;
}
