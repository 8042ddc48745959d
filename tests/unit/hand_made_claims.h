// Claims made by hand, for tests of what check() finds in them. They name contact sets or positions, or they
// are all that is true of some points, and a test changes one thing.
//
// Guarantees: the lines of a claim's points count from 1, in the order in which they were added; what
// Truly::whole_claim() makes conforms exactly.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/truth.h"
#include "tests/true_claims.h"

namespace flowcert {

using Ids = std::vector<PointId>;

inline ClaimedNumber decimal(const Rational& value) { return {value, false}; }
inline ClaimedPosition decimals(const RationalPoint& x) { return {decimal(x[0]), decimal(x[1]), decimal(x[2])}; }

// A claim, point by point, on lines from 1 on.
struct Claimed {
  Claimed& add(int index, const Ids& contact) {
    ClaimedPoint point;
    point.line = claim.points.size() + 1;
    point.index = index;
    point.contact = contact;
    claim.points.push_back(point);
    return *this;
  }
  Claimed& regular(int face, int hull, const Ids& contact) {
    add(face, contact);
    claim.points.back().hull_dimension = hull;
    return *this;
  }
  Claimed& at(int index, const ClaimedPosition& position) {
    add(index, {});
    claim.points.back().center = position;
    return *this;
  }
  ClaimedPoint& last() { return claim.points.back(); }
  // The point that is claimed with this contact set.
  ClaimedPoint& of(const Ids& contact) {
    const auto found = std::ranges::find(claim.points, contact, &ClaimedPoint::contact);
    if (found == claim.points.end()) throw std::invalid_argument("there is no such point");
    return *found;
  }

  Claim claim;
};

// All that is true of some points.
class Truly {
 public:
  explicit Truly(const std::vector<Point>& rows) : points(rows), truth(fast_truth(points)) {}

  // A claim of all critical points except those with the given contact sets.
  [[nodiscard]] Claimed claim_without(const std::vector<Ids>& contacts) const {
    Claimed claimed;
    for (std::size_t i = 0; i < truth->size(); ++i) {
      const Ids contact(truth->contact(i).begin(), truth->contact(i).end());
      if (!truth->index(i).is_critical() || std::ranges::find(contacts, contact) != contacts.end()) continue;
      claimed.add(truth->index(i).face_dimension, contact);
    }
    return claimed;
  }
  [[nodiscard]] Claimed claim() const { return claim_without({}); }
  // All that is true, with incidences, polylines and stable sets. Point k is record k.
  [[nodiscard]] Claimed whole_claim() const { return {.claim = true_claim(points, *truth)}; }
  [[nodiscard]] std::size_t record_of(const Ids& contact) const {
    for (std::size_t i = 0; i < truth->size(); ++i) {
      if (std::ranges::equal(truth->contact(i), contact)) return i;
    }
    throw std::invalid_argument("there is no such point");
  }
  [[nodiscard]] CheckReport check(const Claimed& claimed, const CheckOptions& options = {}) const {
    return flowcert::check(points, claimed.claim, *truth, options);
  }

  PointSet points;
  std::unique_ptr<Truth> truth;
};

// The verdict, and a line for each finding and for what is not judged.
inline std::string text(const CheckReport& report) {
  std::string result = verdict_text(report.verdict);
  for (const Finding& finding : report.findings) {
    result.append("\n").append(std::to_string(finding.level)).append(" ").append(reason_text(finding.reason));
    result.append(" ").append(finding.clause).append(": ").append(finding.claimed);
    result.append("; ").append(finding.truth);
  }
  for (const std::string& what : report.not_judged) result.append("\nnot judged: ").append(what);
  return result;
}

inline std::size_t count(const CheckReport& report, FindingReason reason) {
  return static_cast<std::size_t>(std::ranges::count(report.findings, reason, &Finding::reason));
}

inline void expect_finding(const CheckReport& report, int level, FindingReason reason, const std::string& clause,
                           const std::optional<std::size_t>& line) {
  const bool found = std::ranges::any_of(report.findings, [&](const Finding& finding) {
    return finding.level == level && finding.reason == reason && finding.clause == clause && finding.line == line;
  });
  EXPECT_TRUE(found) << reason_text(reason) << " in " << text(report);
}

const std::vector<Point> kCube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const std::vector<Point> kTetrahedron = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
// The examples of FC-CRIT-03: one regular stationary point each.
const std::vector<Point> kRightTriangle = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
const std::vector<Point> kKind23 = {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}};
const std::vector<Point> kKind13 = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
// From the saddles 0 1 2 and 1 2 4 an orbit ends at the saddle 0 3 4. The Voronoi vertex of 0 1 2 4 lies beneath
// that saddle, and a tie leaves open which of the two ways around the vertex the saddle's boundary goes.
const std::vector<Point> kArch = {{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}};
// An orbit goes from 0 1 3 to 1 2 4, and from there orbits go to two regular stationary points of kind 1-3.
const std::vector<Point> kArchToRegular = {{0, -2, -2}, {-3, 0, -1}, {0, 0, 8}, {0, 2, -2}, {3, 0, -1}};
// A branch of the stable manifold of 0 1 3 ends at the regular stationary point 0 2 3, of kind 1-2.
const std::vector<Point> kRegularBack = {{2, 0, 1}, {0, 0, 0}, {2, 2, 0}, {1, 2, 0}};

inline ClaimedTarget to(const Ids& contact) { return {false, contact}; }
inline const ClaimedTarget kInfinity = {true, {}};

// ---- A claim that is true but for one change

inline const Ids kTriangle = {0, 1, 2};
inline const Ids kSaddleOfArch = {0, 3, 4};

// The report on a claim in which the point of this contact set is changed.
template <typename Change>
std::string said_of(const Truly& truly, const Ids& contact, const Change& change) {
  Claimed claimed = truly.whole_claim();
  change(claimed.of(contact));
  return text(truly.check(claimed));
}

// Moves the position by less than rounding may.
inline void nudge(ClaimedPosition& x) { x[0].value += Rational(1) / (Rational(1 << 30) * Rational(1 << 22)); }
inline void shift(ClaimedPosition& x) { x[0].value += Rational(1, 8); }

}  // namespace flowcert
