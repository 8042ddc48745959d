// What the tests of claims share: an input with the truth about it, random points of claims, and failed
// reports in words.
//
// Guarantees: everything random is drawn with RapidCheck, within a property.
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "certify/truth.h"
#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "tests/property/property_parameters.h"
#include "tests/true_claims.h"

namespace flowcert::property {

constexpr std::size_t kFirstLine = 2;  // of a claim's points

inline std::size_t below(std::size_t count) { return *rc::gen::inRange<std::size_t>(0, count); }

struct ClaimSubject {
  explicit ClaimSubject(const fuzz::Input& rows)
      : input(rows), complex(point_set_of(rows)), points(complex.points()), truth(fast_truth(complex)) {}

  [[nodiscard]] std::vector<PointId> contact(std::size_t i) const { return contact_of(*truth, i); }

  const fuzz::Input& input;
  FlowComplex complex;
  const PointSet& points;
  std::unique_ptr<Truth> truth;
};

inline std::string to_text(const CheckReport& report) {
  std::string text = verdict_text(report.verdict);
  for (const Finding& finding : report.findings) {
    text += "\n  level " + std::to_string(finding.level) + (finding.is_variation ? " permitted " : " ") +
            reason_text(finding.reason) + ' ' + finding.clause + ", line " +
            (finding.line ? std::to_string(*finding.line) : "none") + ": " + finding.claimed + "; " + finding.truth;
  }
  return text + '\n';
}

inline void require(const ClaimSubject& subject, bool holds, const std::string& what, const CheckReport& report) {
  if (holds) return;
  std::ostringstream text;
  text << what << "\ninput:\n" << subject.input << to_text(report);
  RC_FAIL(text.str());
}

// A random one of the points that qualify.
inline std::optional<std::size_t> some_point(const Claim& claim,
                                             const std::function<bool(const ClaimedPoint&)>& qualifies) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < claim.points.size(); ++k) {
    if (qualifies(claim.points[k])) places.push_back(k);
  }
  if (places.empty()) return std::nullopt;
  return places[below(places.size())];
}

// Runs the property on subjects made of inputs of each family, so many of each.
template <typename Subject, typename Property>
void on_all_families(const std::vector<fuzz::Family>& families, int inputs_per_family, Property&& property) {
  bool agreed = true;
  for (const fuzz::Family& family : families) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds(family.name, parameters_of_run(inputs_per_family, agreed),
                          [&] {
                            const fuzz::Input input = *generator;
                            property(Subject(input));
                          }) &&
             agreed;
  }
}

}  // namespace flowcert::property
