// The stationary points of a truth as a conformance vector has them.
#pragma once

#include <vector>

#include "certify/programs/vector_cases.h"
#include "certify/truth.h"

namespace flowcert {

inline std::vector<certify::CasePoint> case_points(Truth& truth) {
  std::vector<certify::CasePoint> points;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto contact = truth.contact(i);
    points.push_back({truth.index(i), {contact.begin(), contact.end()}, truth.sphere(i)});
  }
  return points;
}

}  // namespace flowcert
