#include "morse/explain.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "flowcert/flow_complex.h"
#include "geometry/enclosing_ball.h"
#include "geometry/floating_point.h"
#include "geometry/nearest_samples.h"
#include "geometry/rational_point.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

namespace {

void find_contact(const PointSet& points, const RationalPoint& x, Explanation& answer) {
  NearestSamples nearest = nearest_samples(points, x);
  answer.contact = std::move(nearest.names);
  answer.squared_distance = std::move(nearest.squared_distance);
}

std::vector<Point> coordinates(const PointSet& points, std::span<const PointId> names) {
  std::vector<Point> result;
  for (const PointId name : names) result.push_back(points.at_row(name));
  return result;
}

// Decides condition (d), and the index. C(x) lies on a sphere around x that has no point inside. So x is stationary
// for all points iff it is stationary for C(x) alone, with the same index. The points of C(x) are few, whatever the
// size of the input.
void decide_hull(const PointSet& points, const RationalPoint& x, Explanation& answer) {
  const FlowComplex contact_only(coordinates(points, answer.contact));
  const StationaryPoints& candidates = contact_only.stationary();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates.contact(i).size() != answer.contact.size()) continue;
    if (contact_only.sphere(i).center != x) continue;
    answer.index = candidates.index(i);
    const bool is_critical = answer.index->is_critical();
    answer.clause = is_critical ? "FC-CRIT-02" : "FC-CRIT-03";
    answer.reason = is_critical ? "the centre lies in the relative interior of the hull of its contact set"
                                : "the centre lies in the hull of its contact set, but on its relative boundary";
    return;
  }
  answer.clause = "FC-CRIT-05 (d)";
  answer.reason = "the centre lies outside the hull of its contact set";
  answer.driver = enclosing_ball_center(contact_only.points().points());
}

void require_rows(const PointSet& points, std::span<const PointId> rows) {
  for (const PointId row : rows) {
    if (row < points.row_count()) continue;
    throw InvalidInput("there is no point " + std::to_string(row) + "; the ids are 0 to " +
                       std::to_string(static_cast<long long>(points.row_count()) - 1));
  }
}

}  // namespace

Explanation explain_position(const PointSet& points, const RationalPoint& x) {
  const geometry::IeeeDoubles ieee;
  if (points.empty()) throw InvalidInput("there are no points");
  Explanation answer;
  find_contact(points, x, answer);
  answer.sphere = ExactSphere{x, answer.squared_distance};
  decide_hull(points, x, answer);
  if (!answer.index) {
    answer.clause = "FC-CRIT-01";
    answer.reason = "the position lies outside the hull of its contact set";
  }
  return answer;
}

Explanation explain_points(const PointSet& points, std::span<const PointId> rows) {
  const geometry::IeeeDoubles ieee;
  require_rows(points, rows);
  const std::vector<PointId> names = class_names(points, rows);
  if (names.empty()) throw InvalidInput("no point is named");
  Explanation answer;
  const ExactSphere sphere = exact_sphere(points, names);
  for (const PointId name : names) {
    if (squared_distance(sphere.center, points.at_row(name)) != sphere.squared_radius) {
      answer.witnesses.push_back(name);
    }
  }
  if (!answer.witnesses.empty()) {
    answer.clause = "FC-CRIT-05 (a)";
    answer.reason = "the points lie on no common sphere centred in their affine hull";
    return answer;
  }
  answer.sphere = sphere;
  find_contact(points, sphere.center, answer);
  if (answer.squared_distance < sphere.squared_radius) {
    answer.clause = "FC-CRIT-05 (b)";
    answer.reason = "a point of the input lies strictly inside the sphere";
    answer.witnesses = answer.contact;
    return answer;
  }
  std::set_difference(answer.contact.begin(), answer.contact.end(), names.begin(), names.end(),
                      std::back_inserter(answer.witnesses));
  if (!answer.witnesses.empty()) {
    answer.clause = "FC-CRIT-05 (c)";
    answer.reason = "further points of the input lie on the sphere";
    return answer;
  }
  decide_hull(points, sphere.center, answer);
  return answer;
}

}  // namespace flowcert
