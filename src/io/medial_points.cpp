#include "io/medial_points.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "io/coordinate_rounding.h"
#include "io/layer.h"
#include "morse/log_histogram.h"
#include "morse/saddle_radii.h"

namespace flowcert {

using namespace io;

namespace {

using Float =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

constexpr unsigned kFirstDigits = 40;

// The angles of a rational number of degrees whose cosines are rational; between others no equality is possible
// (FC-MED-02).
std::optional<Rational> rational_cosine(const Rational& degrees) {
  if (degrees == 0) return 1;
  if (degrees == 60) return Rational(1, 2);
  if (degrees == 90) return 0;
  if (degrees == 120) return Rational(-1, 2);
  if (degrees == 180) return -1;
  return std::nullopt;
}

// With two contacts p and q of z, |p - q|^2 = 2 d^2 (1 - cos). So the farthest pair has the largest angle.
Rational contact_cosine(const FlowComplex& complex, std::size_t record) {
  const PointSet& points = complex.points();
  const auto contact = complex.stationary().contact(record);
  const auto at = [&](PointId name) { return geometry::exact_position(points.at_row(name)); };
  Rational farthest = 0;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      farthest = std::max(farthest, geometry::squared_distance(at(contact[i]), at(contact[j])));
    }
  }
  return 1 - farthest / (2 * complex.sphere(record).squared_radius);
}

// The pairs of critical points of index 1 and 2, by record; equal ends where there is none.
std::vector<PairEnds> pairs_of_points(const FlowComplex& complex) {
  std::vector<PairEnds> pairs(complex.stationary().size());
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (!pair.death) continue;
    if (pair.dimension > 0) pairs[pair.birth] = {pair.birth, *pair.death};
    if (pair.dimension < 2) pairs[*pair.death] = {pair.birth, *pair.death};
  }
  return pairs;
}

// The candidates whose numbers, which the order has, are greater.
std::vector<std::size_t> those_above(const std::vector<std::size_t>& candidates, const ValueOrder& order,
                                     const LengthThreshold& threshold, std::optional<AutomaticThreshold>& automatic) {
  automatic = threshold.automatic;
  const std::size_t places = threshold.squared_length ? order.count_up_to(*threshold.squared_length) : 0;
  std::vector<std::size_t> chosen;
  for (std::size_t k = places; k < order.size(); ++k) chosen.push_back(candidates[order.at(k)]);
  std::ranges::sort(chosen);
  return chosen;
}

std::vector<std::size_t> longer_ones(const FlowComplex& complex, const std::vector<std::size_t>& candidates,
                                     const LengthBound& bound, std::optional<AutomaticThreshold>& automatic) {
  const std::vector<PairEnds> pairs = pairs_of_points(complex);
  std::vector<PairEnds> ends;
  ends.reserve(candidates.size());
  for (const std::size_t record : candidates) ends.push_back(pairs[record]);
  const ValueOrder order = length_order(complex.persistence().squared_distances(), ends);
  return those_above(candidates, order,
                     threshold_of(bound, order, squared_spacing(complex), length_rounding(complex.points())),
                     automatic);
}

std::vector<std::size_t> farther_ones(const FlowComplex& complex, const std::vector<std::size_t>& candidates,
                                      const LengthBound& bound, std::optional<AutomaticThreshold>& automatic) {
  const SquaredDistances values(complex.points(), complex.stationary());
  const ValueOrder order = radius_order(values, candidates);
  return those_above(candidates, order, threshold_of(bound, order, squared_spacing(complex)), automatic);
}

}  // namespace

bool is_above_angle(const Rational& cosine, const Rational& degrees) {
  const geometry::IeeeDoubles ieee;
  if (degrees < 0 || degrees > 180) throw InvalidInput("an angle is from 0 to 180 degrees");
  if (const auto exact = rational_cosine(degrees)) return cosine < *exact;
  for (unsigned digits = kFirstDigits;; digits *= 2) {
    const unsigned before = Float::default_precision();
    Float::default_precision(digits);
    const Float bound = cos(Float(degrees) * boost::math::constants::pi<Float>() / 180);
    const Float difference = Float(cosine) - bound;
    // Each of the few operations is rounded by less than a unit of the last of these digits.
    const Float error = pow(Float(10), 4 - static_cast<int>(digits));
    const bool is_decided = abs(difference) > error;
    const bool is_less = difference < 0;
    Float::default_precision(before);
    if (is_decided) return is_less;
  }
}

MedialPoints medial_points(const FlowComplex& complex, const MedialChoice& choice) {
  const geometry::IeeeDoubles ieee;
  const StationaryPoints& stationary = complex.stationary();
  MedialPoints chosen;
  std::vector<std::size_t>& records = chosen.records;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    if (index == StationaryIndex{1, 1} || index == StationaryIndex{2, 2}) records.push_back(record);
  }
  // Quantiles and valleys are of all points, so both choose among all.
  std::vector<std::size_t> farther = records;
  if (choice.radius_above) farther = farther_ones(complex, records, *choice.radius_above, chosen.automatic_radius);
  if (choice.persistence_above) {
    records = longer_ones(complex, records, *choice.persistence_above, chosen.automatic_persistence);
  }
  std::erase_if(records, [&](std::size_t record) { return !std::ranges::binary_search(farther, record); });
  if (choice.angle_above) {
    std::erase_if(records, [&](std::size_t record) {
      const bool is_edge = stationary.index(record) == StationaryIndex{1, 1};
      return !is_above_angle(is_edge ? Rational(-1) : contact_cosine(complex, record), *choice.angle_above);
    });
  }
  return chosen;
}

}  // namespace flowcert
