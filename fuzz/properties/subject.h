// An input as both implementations see it.
//
// Guarantees: exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/persistence.h"
#include "flowcert/stationary_points.h"
#include "fuzz/inputs/input.h"
#include "fuzz/properties/input_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/persistence.h"
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

// Persistence pairs by the fast implementation, in the oracle's structure and order.
inline std::vector<oracle::PersistencePair> persistence_pairs(const FlowComplex& complex) {
  const Persistence& persistence = complex.persistence();
  std::vector<oracle::PersistencePair> pairs;
  for (const PersistencePair& pair : persistence.pairs()) {
    pairs.push_back({pair.dimension, persistence.squared_value(pair.birth), std::nullopt});
    if (pair.death) pairs.back().death = persistence.squared_value(*pair.death);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// A line for each: dimension, birth, death or "inf".
inline std::string to_text(const std::vector<oracle::PersistencePair>& pairs) {
  std::string text;
  for (const oracle::PersistencePair& pair : pairs) {
    text +=
        std::to_string(pair.dimension) + ' ' + pair.birth.str() + ' ' + (pair.death ? pair.death->str() : "inf") + '\n';
  }
  return text;
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
