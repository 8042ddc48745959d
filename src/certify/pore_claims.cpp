// Claims are matched with what is there by exact comparisons, after doubles that are near each other.
#include "certify/pore_claims.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "certify/finding_words.h"
#include "certify/matching.h"
#include "geometry/floating_point.h"
#include "io/line_reader.h"

namespace flowcert {

using namespace certify;

namespace {

using Position = std::array<double, 3>;

// More than what doubles near two equal numbers differ by: as a part of them, and of small ones.
constexpr double kMore = 1e-14, kTiny = std::numeric_limits<double>::min();

// A chamber by its peak, gate or exit, or a window.
struct TruePore {
  PoreKind kind;
  std::optional<QuadraticNumber> diameter;  // nothing where it is below 0
  double near = -1;                         // the nearest double
  std::span<const std::uint32_t> points;    // peaks of the chamber, or the point of the window
  std::vector<Position> positions;          // of these
};

Position doubles(const std::array<QuadraticNumber, 3>& x) {
  return {nearest_or_infinity(x[0]), nearest_or_infinity(x[1]), nearest_or_infinity(x[2])};
}
double distance(const Position& x, const Position& y) { return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]); }

std::string length_text(double length) { return fmt::format("{:.10g}", length); }
std::string difference_text(double off) { return fmt::format("{:.3g} {}", std::abs(off), off < 0 ? "less" : "more"); }

// Half a unit of the last digit of a decimal.
double half_digit(const ClaimedRoot& form) {
  constexpr int kMostDigits = 20;
  Rational scaled = form.value.a;
  for (int digits = 0; !form.is_exact && digits <= kMostDigits; ++digits, scaled *= 10) {
    if (denominator(scaled) == 1) return 0.5 * std::pow(10, -digits);
  }
  return 0;
}

// The first form that is neither equal to it, nor a decimal that is near enough.
ClaimedForms::const_iterator wrong_form(const ClaimedForms& forms, const QuadraticNumber& truth,
                                        const QuadraticNumber& allowance) {
  return std::ranges::find_if(forms, [&](const ClaimedRoot& form) {
    if (form.is_exact) return form.value != truth;
    return nearest_or_infinity(form.value) != nearest_or_infinity(truth) &&
           (form.value > truth + allowance || form.value < truth - allowance);
  });
}
bool is_right(const ClaimedForms& forms, const QuadraticNumber& truth, const QuadraticNumber& allowance) {
  return wrong_form(forms, truth, allowance) == forms.end();
}

class PoreJudge {
 public:
  PoreJudge(const PoreClaim& claim, const Pores& pores, double tolerance)
      : claim_(claim), pores_(pores), tolerance_(tolerance), part_(Rational(tolerance)) {
    for (const Chamber& chamber : pores.chambers()) {
      add(PoreKind::kCavity, chamber.peaks[0], chamber.peaks);
      add(PoreKind::kGate, chamber.gates.empty() ? std::nullopt : std::optional(chamber.gates[0]), chamber.peaks);
      add(PoreKind::kLimiting, chamber.exit, chamber.peaks);
    }
    for (const PoreWindow& window : pores.windows()) add(PoreKind::kWindow, window.point, {&window.point, 1});
    for (std::size_t place = 0; place < truth_.size(); ++place) {
      of_kind_.at(place_of(truth_[place].kind)).places.push_back(place);
    }
  }

  PoreJudgement result() {
    std::vector<Candidates*> candidates;
    for (const ClaimedPore& claimed : claim_.pores) {
      candidates.push_back(claimed.is_greatest ? nullptr : &of_kind_.at(place_of(claimed.kind)));
    }
    const Matching matching = maximum_matching(candidates, truth_.size(), [this](std::size_t k, std::size_t place) {
      return has_diameter(claim_.pores[k], truth_[place]) && is_there(claim_.pores[k], truth_[place]);
    });
    for (std::size_t k = 0; k < claim_.pores.size(); ++k) {
      const ClaimedPore& claimed = claim_.pores[k];
      const bool has_exact = std::ranges::any_of(claimed.diameter, &ClaimedRoot::is_exact);
      if (!claimed.is_beside) {
        ++made_.claimed.at(place_of(claimed.kind));
        made_.is_exact = made_.is_exact && (has_exact || claimed.diameter.empty());
      }
      if (!matching.of_claimed[k]) explain(claimed);
    }
    for (std::size_t place = 0; place < truth_.size(); ++place) {
      const TruePore& truth = truth_[place];
      ++made_.truth.at(place_of(truth.kind));
      if (truth.kind > PoreKind::kWindow || matching.of_truth[place]) continue;
      ++made_.left_out.at(place_of(truth.kind));
      if (claim_.is_whole) report({.kind = truth.kind}, "missing", text_of(truth), "You missed it. This is a bug.");
    }
    return std::move(made_);
  }

 private:
  static std::size_t place_of(PoreKind kind) { return static_cast<std::size_t>(kind); }
  static std::string word_of(PoreKind kind) {
    return kPoreKinds.at(place_of(kind)) + std::string(kind == PoreKind::kLimiting ? " diameter" : "");
  }

  void add(PoreKind kind, std::optional<std::uint32_t> point, std::span<const std::uint32_t> points) {
    TruePore truth{kind, std::nullopt, -1, points, {}};
    if (point) truth.diameter = QuadraticNumber(Rational(2)) * pores_.value(*point);
    if (point) truth.near = nearest_or_infinity(*truth.diameter);
    for (const std::uint32_t each : points) truth.positions.push_back(doubles(pores_.center(each)));
    truth_.push_back(std::move(truth));
  }

  // ---- What is right ----

  [[nodiscard]] QuadraticNumber allowance(const TruePore& truth) const {
    return truth.diameter ? QuadraticNumber(part_) * *truth.diameter : QuadraticNumber();
  }

  [[nodiscard]] bool has_diameter(const ClaimedPore& claimed, const TruePore& truth) const {
    if (claimed.diameter.empty() || !truth.diameter) return claimed.diameter.empty() && !truth.diameter;
    const double off = std::abs(claimed.near - truth.near);
    if (std::isfinite(off) && off > 2 * (tolerance_ + kMore) * truth.near + kTiny) return false;
    return is_right(claimed.diameter, *truth.diameter, allowance(truth));
  }

  [[nodiscard]] bool is_there(const ClaimedPore& claimed, const TruePore& truth) const {
    return std::ranges::all_of(claimed.places, [&](const ClaimedPorePlace& place) {
      for (std::size_t at = 0; at < truth.points.size(); ++at) {
        if (!std::ranges::includes(pores_.points()[truth.points[at]].contact, place.balls)) continue;
        if (!place.position || is_at(place, truth, at)) return true;
      }
      return false;
    });
  }
  [[nodiscard]] bool is_at(const ClaimedPorePlace& claimed, const TruePore& truth, std::size_t at) const {
    const Position& x = truth.positions[at];
    const double size = std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]) + std::abs(truth.near);
    const double away = distance(claimed.near, x);
    if (std::isfinite(away) && away > 2 * (tolerance_ + kMore) * size + kTiny) return false;
    const auto exact = pores_.center(truth.points[at]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!is_right((*claimed.position)[axis], exact[axis], allowance(truth))) return false;
    }
    return true;
  }

  // A place means what is there of the kind. The claim of the greatest one means that.
  [[nodiscard]] std::vector<const TruePore*> meant_by(const ClaimedPore& claimed) const {
    std::vector<const TruePore*> meant;
    for (const std::size_t place : of_kind_.at(place_of(claimed.kind)).places) {
      const TruePore& truth = truth_[place];
      if (!claimed.is_greatest) {
        if (is_there(claimed, truth)) meant.push_back(&truth);
      } else if (truth.diameter && (meant.empty() || *truth.diameter > *meant[0]->diameter)) {
        meant.assign(1, &truth);
      }
    }
    return meant;
  }

  // ---- Why it is wrong, in doubles ----

  // The claim has no partner. One of the greatest needs none.
  void explain(ClaimedPore claimed) {
    std::vector<const TruePore*> meant = meant_by(claimed);
    const auto say = [&](const char* reason, const std::string& truth, const char* sentence) {
      report(claimed, reason, truth, sentence);
    };
    const bool is_there_so =
        std::ranges::any_of(meant, [&](const TruePore* one) { return has_diameter(claimed, *one); });
    if (claimed.is_greatest && (is_there_so || (meant.empty() && claimed.diameter.empty()))) return;
    if (is_there_so)
      return say("claimed-twice", "it is there, but not so often", "You claim it too often. This is a bug.");
    if (meant.empty() && !claimed.places.empty()) {
      return say("wrong-place", text_at(claimed), "There is none at this place. This is a bug.");
    }
    std::erase_if(meant, [](const TruePore* truth) { return !truth->diameter; });
    if (meant.empty() || claimed.diameter.empty()) {
      return say("wrong-diameter", meant.empty() ? "there is none, or it is below 0" : "it is " + text_of(*meant[0]),
                 "What is there is said not to be, or the reverse. This is a bug.");
    }
    const TruePore& nearest = **std::ranges::min_element(
        meant, {}, [&](const TruePore* truth) { return std::abs(truth->near - claimed.near); });
    const ClaimedRoot& wrong = *wrong_form(claimed.diameter, *nearest.diameter, allowance(nearest));
    const double value = nearest_or_infinity(wrong.value), digit = half_digit(wrong);
    if (&wrong != claimed.diameter.data()) claimed.diameter = {wrong};
    // A few digits fit to much.
    const auto is_near = [&](double a, double truth, double most) {
      return std::abs(a - truth) <= std::max(std::min(digit, most * truth), std::max(tolerance_, kMore) * truth);
    };
    constexpr double kAny = 1, kFew = 1e-4;
    const std::string right =
        fmt::format("the {}{} is {}, {}", meant.size() > 1 ? "nearest " : "", word_of(claimed.kind),
                    length_text(nearest.near), difference_text(nearest.near - value));
    if (is_near(value, nearest.near, kAny)) {
      return say("rounding", right,
                 "It is right but for rounding, and --tolerance can allow that. This is a convention.");
    }
    for (const TruePore* truth : meant) {
      if (is_near(2 * value, truth->near, kFew)) {
        return say("radius", "it is half of " + text_of(*truth), "It is a radius. This is a convention.");
      }
      for (const std::uint32_t ball : contacts(*truth)) {
        const double radius = nearest_or_infinity(pores_.balls()[ball].radius);
        if (!is_near(value - 2 * radius, truth->near, kFew)) continue;
        return say("to-centres",
                   fmt::format("less by twice the radius {} it is {}", length_text(radius), text_of(*truth)),
                   "It is measured to centres of atoms, not to surfaces. This is a convention.");
      }
    }
    const auto other = std::ranges::find_if(values(), [&](double of) { return is_near(value, 2 * of, kFew); });
    if (claimed.places.empty() && other != values_.end()) {
      const auto point = static_cast<std::uint32_t>(other - values_.begin());
      return say("wrong-kind", "it is that of " + text_of(point) + "; " + right,
                 "It is something else. This is a bug.");
    }
    say("wrong-diameter", right, "It is another diameter. This is a bug.");
  }

  // Each critical point's value, made when it is asked for.
  const std::vector<double>& values() {
    while (values_.size() < pores_.points().size()) {
      values_.push_back(nearest_or_infinity(pores_.value(static_cast<std::uint32_t>(values_.size()))));
    }
    return values_;
  }

  // ---- In words ----

  [[nodiscard]] std::string text_of(const ClaimedPore& claimed) const {
    std::string text = claimed.name.empty() ? "" : claimed.name + ", ";
    text += word_of(claimed.kind) + ' ';
    if (claimed.diameter.empty()) {
      text += "below 0";
    } else {
      const ClaimedRoot& form = claimed.diameter[0];
      text += form.value.b == 0 ? number_text(ClaimedNumber{form.value.a, form.is_exact})
                                : '~' + length_text(nearest_or_infinity(form.value));
    }
    if (claimed.places.empty()) return text;
    const ClaimedPorePlace& place = claimed.places[0];
    if (place.position) text += fmt::format(" at {:.10g}", fmt::join(place.near, " "));
    return place.balls.empty() ? text : text + ", atoms " + names_text(place.balls);
  }
  [[nodiscard]] std::string text_of(const TruePore& truth) const {
    return fmt::format("the {} {} with atoms {}", word_of(truth.kind), length_text(truth.near),
                       names_text(contacts(truth)));
  }
  [[nodiscard]] const std::vector<std::uint32_t>& contacts(const TruePore& truth) const {
    return pores_.points()[truth.points[0]].contact;
  }

  // What a critical point is.
  [[nodiscard]] std::string text_of(std::uint32_t point) const {
    const auto has = [point](const std::vector<std::uint32_t>& points) {
      return std::ranges::binary_search(points, point);
    };
    const BallPoint& at = pores_.points()[point];
    std::string what = at.index == 3 ? "no peak of a chamber of this depth" : "inside of one room, and no window";
    for (std::size_t number = 0; number < pores_.chambers().size(); ++number) {
      if (has(pores_.chambers()[number].peaks)) what = fmt::format("the peak of chamber {}", number);
      if (has(pores_.chambers()[number].handles)) what = fmt::format("a handle of chamber {}, and no window", number);
    }
    if (std::ranges::find(pores_.windows(), point, &PoreWindow::point) != pores_.windows().end()) what = "a window";
    return fmt::format("a critical point of index {} with atoms {}, {}", at.index, names_text(at.contact), what);
  }

  // What is where nothing of the kind is.
  [[nodiscard]] std::string text_at(const ClaimedPore& claimed) {
    const ClaimedPorePlace& place = claimed.places[0];
    if (!place.position) {
      const auto found = std::ranges::find_if(
          pores_.points(), [&](const BallPoint& point) { return std::ranges::includes(point.contact, place.balls); });
      if (found == pores_.points().end()) return "no critical point has all of these atoms";
      const auto point = static_cast<std::uint32_t>(found - pores_.points().begin());
      return fmt::format("{}, diameter {}", text_of(point), length_text(2 * values()[point]));
    }
    const Position& x = place.near;
    double room = std::numeric_limits<double>::infinity(), away = room;
    const double scale = nearest_or_infinity(pores_.balls().scale());
    for (const std::uint32_t ball : pores_.balls().visible()) {
      const auto& [cx, cy, cz, radius] = pores_.balls().rounded(ball);
      room = std::min(room, distance(x, {cx / scale, cy / scale, cz / scale}) - radius / scale);
    }
    const TruePore* nearest = nullptr;
    for (const std::size_t number : of_kind_.at(place_of(claimed.kind)).places) {
      for (const Position& y : truth_[number].positions) {
        if (distance(x, y) < away) away = distance(x, y), nearest = &truth_[number];
      }
    }
    const std::string text = fmt::format("a ball of diameter {} has room there", length_text(2 * room));
    return nearest == nullptr ? text : fmt::format("{}; {:.3g} away is {}", text, away, text_of(*nearest));
  }

  // One without a line is not claimed.
  void report(const ClaimedPore& claimed, const char* reason, const std::string& truth, const char* sentence) {
    const bool is_claimed = claimed.line > 0;
    made_.differences.push_back({is_claimed ? text_of(claimed) : "nothing", truth, reason,
                                 static_cast<int>(claimed.kind), is_claimed, true, claimed.line, sentence});
  }

  const PoreClaim& claim_;
  const Pores& pores_;
  const double tolerance_;
  const QuadraticNumber part_;
  std::vector<TruePore> truth_;
  std::array<Candidates, kPoreKinds.size()> of_kind_;  // places in that
  std::vector<double> values_;
  PoreJudgement made_;
};

}  // namespace

PoreJudgement judge_pores(const PoreClaim& claim, const Pores& pores, double tolerance, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  const std::size_t count = pores.balls().size();
  if (claim.balls && *claim.balls != count) {
    reject_file(name, fmt::format("a claim about {} balls, and the input has {}", *claim.balls, count));
  }
  for (const ClaimedPore& claimed : claim.pores) {
    for (const ClaimedPorePlace& place : claimed.places) {
      if (place.balls.empty() || place.balls.back() < count) continue;
      LinePlace{.file = name, .line = claimed.line}.reject(
          fmt::format("there is no ball {}; the input has {}", place.balls.back(), count));
    }
  }
  return PoreJudge(claim, pores, tolerance).result();
}

}  // namespace flowcert
