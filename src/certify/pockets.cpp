// Level 5 for pockets, and level 3 for the counts beside them (FC-CLAIM-18). Its maxima identify a claimed pocket.
// What is claimed exactly is compared exactly, and no perturbation excuses a difference.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "geometry/difference_of_roots.h"

namespace flowcert::certify {

namespace {

constexpr char kPocketClause[] = "FC-POCK-02";
// What a claimed area may be off, beside the tolerance: twice the error that FC-POCK-11 permits, and a little more.
constexpr double kAreaPart = 0x1p-38, kTinyArea = 0x1p-1059;

using Records = std::vector<std::uint32_t>;

class ClaimedLandscape {
 public:
  explicit ClaimedLandscape(CheckRun& run)
      : run_(run), claimed_(*run.claim.pockets), truth_(run.truth.pockets(claimed_.squared_persistence)) {}

  void check() {
    match_pockets();
    check_outside();
    check_whole(claimed_.pore_limiting_radius, truth_.widest ? truth_.widest->gates : Records{}, "pore limiting radius",
                "FC-POCK-07");
    check_whole(claimed_.largest_cavity_radius, truth_.largest_balls, "largest cavity radius", "FC-POCK-08");
    if (!all_are_matched_ && !claimed_.pockets.empty()) {
      run_.leave_unjudged("neighbours of pockets, and what mouths are between, because not all pockets are right");
    }
    for (std::size_t k = 0; k < claimed_.pockets.size(); ++k) {
      run_.show_progress(5, k, claimed_.pockets.size());
      if (number_of_[k]) check_pocket(k, truth_.pockets[*number_of_[k]]);
    }
  }

 private:
  // ---- Which pocket is meant ----

  void match_pockets() {
    std::map<Records, std::uint32_t> by_maxima;
    for (std::uint32_t n = 0; n < truth_.pockets.size(); ++n) by_maxima[truth_.pockets[n].maxima] = n;
    std::vector<bool> is_claimed(truth_.pockets.size(), false);
    for (std::size_t k = 0; k < claimed_.pockets.size(); ++k) {
      number_of_.push_back(number_of(k, by_maxima));
      if (!number_of_[k]) continue;
      if (is_claimed[*number_of_[k]]) find(k, FindingReason::kClaimedTwice, kPocketClause, "", "it is there already");
      is_claimed[*number_of_[k]] = true;
    }
    for (std::uint32_t n = 0; n < truth_.pockets.size(); ++n) {
      if (is_claimed[n]) continue;
      const std::uint32_t first = truth_.pockets[n].maxima.front();
      run_.find_unclaimed(first,
                          {.level = 5,
                           .reason = FindingReason::kWrongPocket,
                           .clause = kPocketClause,
                           .claimed = "no such pocket",
                           .truth = "a pocket of " + count_text(truth_.pockets[n].maxima.size(), "maximum", "maxima") +
                                    ", with " + stationary_text(run_.truth, first)});
      all_are_matched_ = false;
    }
  }

  std::optional<std::uint32_t> number_of(std::size_t k, const std::map<Records, std::uint32_t>& by_maxima) {
    std::set<std::uint32_t> maxima;
    for (const auto& contact : claimed_.pockets[k].maxima) {
      const auto record = record_of(contact);
      if (!record || run_.index(*record) != kMaximum) {
        find(k, FindingReason::kWrongPocket, "FC-POCK-01", "a maximum " + names_text(contact), "it is no maximum");
        all_are_matched_ = false;
        return std::nullopt;
      }
      maxima.insert(*record);
    }
    const auto found = by_maxima.find(Records(maxima.begin(), maxima.end()));
    if (found != by_maxima.end() && maxima.size() == claimed_.pockets[k].maxima.size()) return found->second;
    find(k, FindingReason::kWrongPocket, kPocketClause, count_text(maxima.size(), "maximum", "maxima"),
         "no pocket has these maxima" + pocket_of(*maxima.begin()));
    all_are_matched_ = false;
    return std::nullopt;
  }

  // Where a maximum really is, in words.
  [[nodiscard]] std::string pocket_of(std::uint32_t maximum) const {
    for (const Pocket& pocket : truth_.pockets) {
      if (!std::ranges::binary_search(pocket.maxima, maximum)) continue;
      return "; its first one is in a pocket of " + std::to_string(pocket.maxima.size());
    }
    return "; its first one belongs to the outside";
  }

  void check_outside() {
    if (!claimed_.outside) return;
    const auto records = records_of(*claimed_.outside);
    if (records && *records == truth_.outside) return;
    run_.find_whole(5, FindingReason::kWrongPocket, kPocketClause,
                    count_text(claimed_.outside->size(), "maximum", "maxima") + " of the outside",
                    (records ? "there are " : "not all of them are stationary; there are ") +
                        std::to_string(truth_.outside.size()) + ", which are other ones");
  }

  // ---- Names ----

  [[nodiscard]] std::optional<std::uint32_t> record_of(const std::vector<PointId>& contact) {
    const auto place = placement_of(run_, class_names(run_.points, contact));
    if (!place || place->fit == Fit::kOther) return std::nullopt;
    return static_cast<std::uint32_t>(place->record);
  }

  // Ascending. Nothing if one is not stationary, or is there twice.
  [[nodiscard]] std::optional<Records> records_of(const std::vector<std::vector<PointId>>& contacts) {
    Records records;
    for (const auto& contact : contacts) {
      const auto record = record_of(contact);
      if (!record) return std::nullopt;
      records.push_back(*record);
    }
    std::ranges::sort(records);
    return std::ranges::adjacent_find(records) == records.end() ? std::optional(records) : std::nullopt;
  }

  // Pockets of the claim as true ones, ascending. All pockets are matched.
  [[nodiscard]] Records true_numbers(const std::vector<std::int64_t>& claimed) const {
    Records numbers;
    for (const std::int64_t number : claimed) {
      numbers.push_back(number < 0 ? static_cast<std::uint32_t>(truth_.pockets.size())
                                   : *number_of_[static_cast<std::size_t>(number)]);
    }
    std::ranges::sort(numbers);
    return numbers;
  }

  // ---- One pocket ----

  void check_pocket(std::size_t k, const Pocket& truth) {
    const ClaimedPocket& claimed = claimed_.pockets[k];
    check_peaks(k, truth);
    check_cell(k, truth);
    check_mouths(k, truth);
    if (claimed.difference_of_squares) check_difference_of_squares(k, truth);
    if (claimed.depth) check_depth(k, truth);
    if (claimed.volume) check_volume(k, truth);
    if (claimed.lining) check_lining(k, truth);
    if (claimed.neighbours && all_are_matched_) {
      if (true_numbers(*claimed.neighbours) != truth.neighbours) {
        find(k, FindingReason::kWrongPocket, "FC-POCK-04", count_text(claimed.neighbours->size(), "neighbour"),
             "it has " + std::to_string(truth.neighbours.size()) + ", which are other ones");
      }
    }
    if (claimed.widest_path) {
      report(k, complaint_about_radius(*claimed.widest_path, truth.to_infinity.gates), "FC-POCK-07", "widest path");
    }
    check_passage(k, truth);
  }

  void check_peaks(std::size_t k, const Pocket& truth) {
    const auto& peaks = claimed_.pockets[k].peaks;
    if (peaks) report(k, complaint_about_witnesses(*peaks, truth.peaks), "FC-POCK-05", "peaks");
  }

  void check_cell(std::size_t k, const Pocket& truth) {
    if (!claimed_.pockets[k].cell) return;
    std::vector<std::vector<PointId>> contacts;
    bool has_indices = true;
    for (const ClaimedCellPart& part : *claimed_.pockets[k].cell) {
      contacts.push_back(part.contact);
      const auto record = record_of(part.contact);
      const int hull_dimension = part.hull_dimension.value_or(part.index);
      has_indices = has_indices && record && run_.index(*record).face_dimension == part.index &&
                    run_.index(*record).hull_dimension == hull_dimension;
    }
    const auto records = records_of(contacts);
    if (has_indices && records && *records == truth.cell) return;
    find(k, FindingReason::kWrongPocket, "FC-POCK-03", "a cell of " + count_text(contacts.size(), "stable set"),
         has_indices && records ? "it has " + std::to_string(truth.cell.size()) + ", which are other ones"
                                : "not all of these are stationary points of these indices");
  }

  void check_mouths(std::size_t k, const Pocket& truth) {
    const auto& mouths = claimed_.pockets[k].mouths;
    if (!mouths) return;
    std::vector<ClaimedWitness> witnesses;
    for (const ClaimedMouth& mouth : *mouths) witnesses.push_back(mouth.at);
    const auto complaint = complaint_about_witnesses(witnesses, truth.mouths);
    report(k, complaint, "FC-POCK-04", "mouths");
    if (complaint) return;
    for (const ClaimedMouth& mouth : *mouths) check_mouth(k, mouth, *record_of(mouth.at.contact));
  }

  void check_mouth(std::size_t k, const ClaimedMouth& mouth, std::uint32_t record) {
    if (mouth.between && all_are_matched_ && true_numbers(*mouth.between) != truth_.above_mouths.at(record)) {
      find(k, FindingReason::kWrongPocket, "FC-POCK-04", "a mouth " + names_text(mouth.at.contact) + " between others",
           "other pockets are above it");
    }
    if (!mouth.area) return;
    const double area = run_.truth.area(record);
    if (is_right_area(*mouth.area, area)) return;
    find(k, FindingReason::kWrongPocket, "FC-POCK-11",
         "a mouth " + names_text(mouth.at.contact) + " of area " + double_text(mouth.area->number),
         "its area is about " + number_text(area));
  }

  [[nodiscard]] bool is_right_area(const ClaimedDouble& claimed, double area) const {
    if (!claimed.number || std::isinf(area)) return !claimed.number && std::isinf(area);
    const Rational off = abs(Rational(claimed.number->value - Rational(area)));
    return off <= (Rational(run_.options.tolerance) + Rational(kAreaPart)) * Rational(area) ||
           off <= Rational(kTinyArea);
  }

  // Whether it is what doubles say: the nearest one, or that none is near.
  static bool is_double(const ClaimedDouble& claimed, double nearest) {
    if (!claimed.number) return std::isinf(nearest);
    return !claimed.number->is_exact && nearest_double(claimed.number->value) == nearest;
  }

  // The squared distance of a point.
  [[nodiscard]] Rational value(std::uint32_t record) { return run_.truth.sphere(record).squared_radius; }

  void check_difference_of_squares(std::size_t k, const Pocket& truth) {
    const ClaimedNumber& claimed = *claimed_.pockets[k].difference_of_squares;
    run_.note_exactness(claimed.is_exact);
    const Rational top = value(truth.peaks.front()), difference = top - value(truth.highest_mouth);
    if (claimed.value == difference) return;
    const Rational off = abs(Rational(claimed.value - difference));
    const bool is_near = off <= Rational(run_.options.tolerance) * top || rounds_alike(claimed.value, difference);
    if (!claimed.is_exact && is_near) return;
    find(k, rounding_or(FindingReason::kWrongPocket, off <= Rational(kRoundingPart) * top), "FC-POCK-05",
         "a difference of squares of " + number_text(claimed), "it is " + number_text(difference));
  }

  // Near means near to the nearest double.
  void check_depth(std::size_t k, const Pocket& truth) {
    const ClaimedDouble& claimed = *claimed_.pockets[k].depth;
    const Rational top = value(truth.peaks.front());
    const double depth = geometry::nearest_difference_of_roots(top, value(truth.highest_mouth));
    if (!claimed.number || std::isinf(depth)) {
      if (!claimed.number && std::isinf(depth)) return;
    } else {
      const double radius = geometry::nearest_difference_of_roots(top, 0);
      const Rational off = abs(Rational(claimed.number->value - Rational(depth)));
      if (nearest_double(claimed.number->value) == depth) return;
      if (std::isfinite(radius) && off <= Rational(run_.options.tolerance) * Rational(radius)) return;
    }
    find(k, FindingReason::kWrongPocket, "FC-POCK-11", "depth " + double_text(claimed.number),
         "the depth is " + number_text(depth));
  }

  // Any row of a class stands for it, once.
  void check_lining(std::size_t k, const Pocket& truth) {
    const std::vector<PointId>& claimed = *claimed_.pockets[k].lining;
    std::set<PointId> samples;
    for (const std::uint32_t record : truth.cell) {
      for (const auto& [name, share] : run_.truth.nearest_shares(record)) samples.insert(name);
    }
    const std::vector<PointId> names = class_names(run_.points, claimed);
    if (names.size() == claimed.size() && std::ranges::equal(names, samples)) return;
    find(k, FindingReason::kWrongPocket, "FC-POCK-03", "a lining of " + count_text(claimed.size(), "sample"),
         "it has " + std::to_string(samples.size()) + (names.size() == samples.size() ? ", which are other ones" : ""));
  }

  void check_volume(std::size_t k, const Pocket& truth) {
    const ClaimedDouble& claimed = *claimed_.pockets[k].volume;
    const double nearest = run_.truth.nearest_sum(truth.cell);
    const bool is_exact = claimed.number && claimed.number->is_exact;
    run_.note_exactness(is_exact);
    if (is_double(claimed, nearest)) return;
    Rational volume = 0;
    for (const std::uint32_t record : truth.cell) volume += run_.truth.volume(record);
    const ValueMatch match =
        claimed.number ? match_volume(*claimed.number, volume, run_.options.tolerance) : ValueMatch::kOff;
    if (!is_wrong(match)) return;
    find(k, rounding_or(FindingReason::kWrongVolume, match), "FC-POCK-03", "volume " + double_text(claimed.number),
         "the volume is " + number_text(volume));
  }

  // FC-POCK-06.
  void check_passage(std::size_t k, const Pocket& truth) {
    const std::string& claimed = claimed_.pockets[k].passage;
    if (claimed.empty()) return;
    const Rational least = *claimed_.probe * *claimed_.probe;
    const auto is_open = [&](std::uint32_t record) { return value(record) >= least; };
    const auto open = std::ranges::count_if(truth.mouths, is_open);
    const char* const right = !is_open(truth.to_infinity.gates.front()) ? "cavity" : open == 1 ? "pocket" : "channel";
    if (claimed == right) return;
    find(k, FindingReason::kWrongPocket, "FC-POCK-06", claimed, std::string("for the probe it is a ") + right);
  }

  // ---- Points with their values ----

  struct Complaint {
    FindingReason reason = FindingReason::kWrongPocket;
    std::string claimed, truth;
  };

  // Whether these are the true points, each once, with right values.
  std::optional<Complaint> complaint_about_witnesses(const std::vector<ClaimedWitness>& claimed, const Records& truth) {
    std::vector<std::vector<PointId>> contacts;
    contacts.reserve(claimed.size());
    for (const ClaimedWitness& one : claimed) contacts.push_back(one.contact);
    const auto records = records_of(contacts);
    if (!records || *records != truth) {
      std::string right = truth.empty() ? "there is none"
                                        : "there are " + std::to_string(truth.size()) + ", the first one at " +
                                              names_text(run_.truth.contact(truth.front()));
      return Complaint{FindingReason::kWrongPocket, std::to_string(claimed.size()) + " other points", std::move(right)};
    }
    for (const ClaimedWitness& one : claimed) {
      const std::uint32_t record = *record_of(one.contact);
      const ExactSphere sphere = run_.truth.sphere(record);
      const ValueScale scale(sphere, run_.options.tolerance);
      if (one.center) {
        const ValueMatch match = run_.match(*one.center, sphere.center, scale);
        if (is_wrong(match)) {
          return Complaint{rounding_or(FindingReason::kWrongPocket, match), "at " + position_text(*one.center),
                           "it is at " + position_text(sphere.center)};
        }
      }
      if (auto complaint = complaint_about_radii(one.squared_radius, one.radius, record)) return complaint;
    }
    return std::nullopt;
  }

  std::optional<Complaint> complaint_about_radii(const std::optional<ClaimedNumber>& squared_radius,
                                                 const std::optional<ClaimedDouble>& radius, std::uint32_t record) {
    const ExactSphere sphere = run_.truth.sphere(record);
    const ValueScale scale(sphere, run_.options.tolerance);
    const auto complain = [&](ValueMatch match, const std::string& claimed) {
      return Complaint{rounding_or(FindingReason::kWrongPocket, match), claimed,
                       "the squared radius is " + number_text(sphere.squared_radius)};
    };
    if (squared_radius) {
      run_.note_exactness(squared_radius->is_exact);
      const ValueMatch match = match_squared_distance(*squared_radius, sphere.squared_radius, scale);
      if (is_wrong(match)) return complain(match, "a squared radius of " + number_text(*squared_radius));
    }
    if (!radius) return std::nullopt;
    run_.note_exactness(squared_radius || (radius->number && radius->number->is_exact));
    const double nearest = geometry::nearest_difference_of_roots(sphere.squared_radius, 0);
    if (is_double(*radius, nearest)) return std::nullopt;
    const ValueMatch match =
        radius->number ? match_distance(*radius->number, sphere.squared_radius, scale) : ValueMatch::kOff;
    return is_wrong(match) ? std::optional(complain(match, "a radius of " + double_text(radius->number)))
                           : std::nullopt;
  }

  std::optional<Complaint> complaint_about_radius(const ClaimedRadius& claimed, const Records& truth) {
    if (auto complaint = complaint_about_witnesses(claimed.witnesses, truth)) return complaint;
    return complaint_about_radii(claimed.squared_radius, claimed.radius, truth.front());
  }

  void check_whole(const std::optional<ClaimedWhole>& claimed, const Records& truth, const std::string& what,
                   const char* clause) {
    if (!claimed) return;
    std::optional<Complaint> complaint;
    if (claimed->radius.has_value() != !truth.empty()) {
      complaint = {FindingReason::kWrongPocket, claimed->radius ? "there is one" : "there is none",
                   truth.empty() ? "there is none, because there is no pocket" : "there is one"};
    } else if (claimed->radius) {
      complaint = complaint_about_radius(*claimed->radius, truth);
    }
    if (complaint) run_.find_whole(5, complaint->reason, clause, what + ": " + complaint->claimed, complaint->truth);
  }

  // ---- Findings ----

  static std::string number_text(double value) {
    return std::isinf(value) ? "beyond the doubles" : certify::number_text(Rational(value));
  }
  static std::string number_text(const Rational& value) { return certify::number_text(value); }
  static std::string number_text(const ClaimedNumber& value) { return certify::number_text(value); }

  static std::string count_text(std::size_t count, const std::string& one, const std::string& several = "") {
    return std::to_string(count) + " " + (count == 1 ? one : several.empty() ? one + "s" : several);
  }

  void report(std::size_t k, const std::optional<Complaint>& complaint, const std::string& clause,
              const std::string& what) {
    if (complaint) find(k, complaint->reason, clause, what + ": " + complaint->claimed, complaint->truth);
  }

  void find(std::size_t k, FindingReason reason, const std::string& clause, const std::string& claimed,
            const std::string& truth) {
    run_.report.findings.push_back({.level = 5,
                                    .reason = reason,
                                    .clause = clause,
                                    .line = claimed_.line,
                                    .contact = claimed_.pockets[k].maxima.front(),
                                    .claimed = "pocket " + std::to_string(k) + (claimed.empty() ? "" : ", " + claimed),
                                    .truth = truth});
  }

  CheckRun& run_;
  const ClaimedPockets& claimed_;
  const TruePockets truth_;
  std::vector<std::optional<std::uint32_t>> number_of_;  // by claimed pocket
  bool all_are_matched_ = true;
};

template <std::size_t N>
void check_counts(CheckRun& run, const std::array<std::size_t, N>& claimed, const std::array<std::size_t, N>& truth,
                  const std::string& what) {
  if (claimed == truth) return;
  run.find_whole(3, FindingReason::kWrongCounts, "FC-CLAIM-18", fmt::format("{} {}", fmt::join(claimed, " "), what),
                 fmt::format("there are {}", fmt::join(truth, " ")));
}

}  // namespace

bool check_counts_of_pockets(CheckRun& run) {
  const ClaimedPockets& pockets = *run.claim.pockets;
  std::array<std::size_t, 4> critical{};
  std::array<std::size_t, 3> regular{};
  for (std::size_t i = 0; i < run.truth.size(); ++i) {
    const StationaryIndex index = run.index(i);
    const std::size_t kind = index.face_dimension + index.hull_dimension - 3U;  // 1-2, 1-3, 2-3
    ++(index.is_critical() ? critical.at(index.face_dimension) : regular.at(kind));
  }
  if (pockets.critical_counts) check_counts(run, *pockets.critical_counts, critical, "critical points");
  if (pockets.regular_counts) {
    check_counts(run, *pockets.regular_counts, regular, "regular stationary points of kinds 1-2, 1-3, 2-3");
  }
  return pockets.critical_counts || pockets.regular_counts;
}

bool check_pockets(CheckRun& run) {
  if (!run.claim.pockets) return false;
  ClaimedLandscape(run).check();
  return true;
}

}  // namespace flowcert::certify
