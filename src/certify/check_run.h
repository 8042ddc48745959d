// What the levels of a check share: the claim, the truth, where each claimed point is among the true
// stationary points, and the report that they write.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/contact_index.h"
#include "certify/value_match.h"
#include "flowcert/check.h"

namespace flowcert::certify {

// How well a claimed contact set names the stationary point that it has the centre of.
enum class Fit {
  kWhole,     // it is its contact set
  kPart,      // an affinely independent part of it that spans the same affine hull (FC-CLAIM-02)
  kOther,     // some other part with that centre
  kPosition,  // none is claimed; by position
};

struct Placement {
  std::size_t record = 0;  // in the truth
  Fit fit = Fit::kWhole;
};

struct PlacedPoint {
  bool is_well_formed = false;
  std::vector<PointId> names;  // the claimed contact set, by classes, ascending
  std::optional<Placement> place;
  std::vector<std::size_t> alternatives;  // all within the tolerance, where they are several
  bool is_right = false;  // claims rightly what is there: its successors and polylines can be judged
};

struct CheckRun {
  CheckRun(const PointSet& points_, const Claim& claim_, Truth& truth_, const CheckOptions& options_)
      : points(points_),
        claim(claim_),
        truth(truth_),
        options(options_),
        contacts(points_, truth_),
        placed(claim_.points.size()) {}

  const PointSet& points;
  const Claim& claim;
  Truth& truth;
  const CheckOptions& options;
  ContactIndex contacts;
  std::vector<PlacedPoint> placed;  // by claimed point
  CheckReport report;

  [[nodiscard]] StationaryIndex index(std::size_t record) const { return truth.index(record); }
  // About a claimed point.
  void find(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
            const std::string& truth_text);
  // Likewise, permitted.
  void vary(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
            const std::string& truth_text);
  // Says so once.
  void leave_unjudged(const std::string& what);
};

// Classes of the rows, ascending, each once.
[[nodiscard]] std::vector<PointId> class_names(const PointSet& points, const std::vector<PointId>& rows);

// The stationary point with the same centre as the smallest sphere through these samples, if it is one.
[[nodiscard]] std::optional<Placement> placement_of(CheckRun& run, const std::vector<PointId>& names);

// Level 1. Sets is_well_formed and names.
void check_form(CheckRun& run);
// Finds out where the well-formed points are. Reports what is ambiguous.
void place_points(CheckRun& run);
// Levels 2 and 3, of what is claimed: by stationary point, what is claimed there, and what is claimed
// elsewhere.
void check_claims_at_critical(CheckRun& run, std::size_t record, const std::vector<std::size_t>& claimed);
void check_claims_at_regular(CheckRun& run, std::size_t record, const std::vector<std::size_t>& claimed);
void check_stray_claim(CheckRun& run, std::size_t claimed_point);
// Centre and distance of a claimed point that has a place.
void check_values(CheckRun& run, std::size_t claimed_point);
// Level 3, of what is not claimed.
void check_missing(CheckRun& run, std::size_t record);
void check_euler_sum(CheckRun& run);
// Levels 4 and 5. True if there was something to judge.
bool check_incidences(CheckRun& run);
bool check_polylines(CheckRun& run);
bool check_surfaces(CheckRun& run);

}  // namespace flowcert::certify
