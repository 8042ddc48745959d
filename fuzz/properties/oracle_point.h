// A stationary point of the fast implementation's list as the oracle has them, so that the oracle can be
// asked about it.
//
// Guarantees: exact.
#pragma once

#include <cstddef>

#include "flowcert/stationary_points.h"
#include "oracle/stationary_points.h"

namespace flowcert::property {

inline oracle::StationaryPoint oracle_point(const PointSet& points, const StationaryPoints& stationary,
                                            std::size_t record) {
  const auto contact = stationary.contact(record);
  const ExactSphere sphere = exact_sphere(points, contact);
  return {sphere.center,
          sphere.squared_radius,
          {contact.begin(), contact.end()},
          stationary.index(record).face_dimension,
          stationary.index(record).hull_dimension};
}

}  // namespace flowcert::property
