// An input as both implementations see it.
//
// Guarantees: exact.
#pragma once

#include <cstddef>
#include <memory>

#include "flowcert/flow_complex.h"
#include "flowcert/stationary_points.h"
#include "fuzz/inputs/input.h"
#include "fuzz/properties/input_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/stationary_points.h"

namespace flowcert::property {

// A stationary point of the fast implementation's list, in the oracle's form, so that the oracle can be asked about
// it.
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

struct Subject {
  explicit Subject(const fuzz::Input& rows) : input(rows), complex(point_set_of(rows)), set(rows.rows) {}

  const fuzz::Input& input;
  FlowComplex complex;
  oracle::fast::PointSet set;
};

// The thread keeps the input that it asked for last. So the diagram and manifolds of a case are made once, although
// several properties and its signature look at them. The reference holds until the thread asks for another input.
inline const Subject& subject_of(const fuzz::Input& input) {
  struct Kept {
    explicit Kept(const fuzz::Input& rows) : input(rows), subject(input) {}
    fuzz::Input input;
    Subject subject;
  };
  thread_local std::unique_ptr<Kept> kept;
  if (!kept || kept->input != input) kept = std::make_unique<Kept>(input);
  return kept->subject;
}

}  // namespace flowcert::property
