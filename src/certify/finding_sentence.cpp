#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

// "edge 0 1", "triangle 0 1 2", "the 5 points 0 1 2 3 4": how people call so many points.
std::string simplex_text(std::span<const PointId> names) {
  constexpr std::array kSimplices = {"", "point", "edge", "triangle", "tetrahedron"};
  if (names.size() < kSimplices.size()) return fmt::format("{} {}", kSimplices[names.size()], names_text(names));
  return fmt::format("the {} points {}", names.size(), names_text(names));
}

std::string times_text(std::size_t count) {
  constexpr std::array kWords = {"no", "one", "two", "three", "four", "five", "six", "seven", "eight"};
  return count < kWords.size() ? kWords[count] : std::to_string(count);
}

class Sentence {
 public:
  Sentence(const Finding& finding, const Truth& truth) : finding_(finding), truth_(truth) {}

  [[nodiscard]] std::string text() const {
    const std::string what = of_points();
    if (!what.empty()) return what;
    return of_manifolds();
  }

 private:
  static std::string bug(const std::string& what) { return what + " This is a bug."; }
  static std::string convention(const std::string& what, const std::string& otherwise) {
    return what + " This is a convention: " + otherwise;
  }

  // "the saddle of triangle 0 1 2 (index 2)"
  [[nodiscard]] std::string true_point() const {
    if (!finding_.record) return simplex_text(finding_.contact);
    const StationaryIndex index = truth_.index(*finding_.record);
    const auto contact = truth_.contact(*finding_.record);
    const auto size = static_cast<std::size_t>(index.hull_dimension) + 1;
    if (!index.is_critical()) {
      return fmt::format("the regular stationary point of {} (kind {}-{})", simplex_text(contact), index.face_dimension,
                         index.hull_dimension);
    }
    if (index.hull_dimension == 0) return simplex_text(contact);
    const char* const kind = index.hull_dimension == 3 ? "maximum" : "saddle";
    const char* const lie = index.hull_dimension == 3 ? "cospherical" : "cocircular";
    const std::string of = contact.size() == size
                               ? simplex_text(contact)
                               : fmt::format("the {} {} points {}", contact.size(), lie, names_text(contact));
    return fmt::format("the {} of {} (index {})", kind, of, index.hull_dimension);
  }

  // The true contact set's points that are not named.
  [[nodiscard]] std::vector<PointId> others() const {
    std::vector<PointId> names;
    if (!finding_.record) return names;
    const auto contact = truth_.contact(*finding_.record);
    std::ranges::set_difference(contact, finding_.contact, std::back_inserter(names));
    return names;
  }

  [[nodiscard]] std::string of_points() const {
    const std::string claimed = simplex_text(finding_.contact);
    switch (finding_.reason) {
      case FindingReason::kMalformed:
        return bug("The claim contradicts its input, or itself.");
      case FindingReason::kNotCospherical:
        return bug(fmt::format("No sphere that is centred in the hull of {} goes through all of them.", claimed));
      case FindingReason::kBallNotEmpty:
        return bug(
            fmt::format("Another point lies inside of the smallest sphere through {}, so that its centre is not "
                        "critical.",
                        claimed));
      case FindingReason::kContactIncomplete:
        return incomplete_text();
      case FindingReason::kOutsideHull:
        return bug(fmt::format("The centre of the sphere through {} lies outside of them, so that it is not critical.",
                               claimed));
      case FindingReason::kCollisionAsCritical:
        return collision_text();
      case FindingReason::kWrongIndex:
        return bug(fmt::format("The index is wrong: you have {}, and it is {}.", finding_.claimed, finding_.truth));
      case FindingReason::kWrongPosition:
        return bug("The place or the distance is off by more than rounding explains.");
      case FindingReason::kRounding:
        return convention("It is right but for rounding.", "decimals may be rounded; fractions may not.");
      case FindingReason::kMissing:
        return bug(fmt::format("You missed {}.", true_point()));
      case FindingReason::kMissedByCluster:
        return bug(fmt::format("You missed {}, where more points lie on one sphere than a simplex has.", true_point()));
      case FindingReason::kClaimedTwice:
        return bug(fmt::format("You named {} twice.", true_point()));
      case FindingReason::kAmbiguous:
        return convention("Several stationary points are within the tolerance of what you claim.",
                          "name the points that it is nearest to, or claim more digits.");
      case FindingReason::kWrongCounts:
        return bug(fmt::format("The counts are wrong: you have {}; {}.", finding_.claimed, finding_.truth));
      case FindingReason::kSpanningPart:
        return convention(fmt::format("You named {} of the points on its sphere, which span the same.",
                                      times_text(finding_.contact.size())),
                          "all of them are asked for, and this is permitted.");
      case FindingReason::kSymbolicPerturbation:
        return convention("It is right for points that are moved a little, and not for these.",
                          "a program that breaks ties so is said to be perturbed; --strict refuses it.");
      default:
        return "";
    }
  }

  [[nodiscard]] std::string incomplete_text() const {
    if (!finding_.record)
      return bug(fmt::format("More points lie on the sphere of {}.", simplex_text(finding_.contact)));
    const auto contact = truth_.contact(*finding_.record);
    std::string count = times_text(contact.size());
    if (!count.empty() && count.front() >= 'a') count.front() = static_cast<char>(count.front() - 'a' + 'A');
    return bug(fmt::format("{} points lie on this sphere ({}); you named {}.", count, names_text(contact),
                           times_text(finding_.contact.size())));
  }

  // Where two points collide that a simplex has: what is permitted there (FC-CLAIM-04).
  [[nodiscard]] std::string permitted_text() const {
    if (!finding_.record) return "";
    const StationaryIndex index = truth_.index(*finding_.record);
    const auto contact = truth_.contact(*finding_.record);
    const bool is_pair = index.hull_dimension == index.face_dimension + 1;
    if (!is_pair || contact.size() != static_cast<std::size_t>(index.hull_dimension) + 1) return "";
    return fmt::format(" Right is to claim nothing there; the {} beside the {} is permitted.",
                       index.face_dimension == 1 ? "edge" : "triangle", simplex_text(contact));
  }

  [[nodiscard]] std::string collision_text() const {
    const std::string moving = "Moving the points a little would not make this answer right." + permitted_text();
    if (finding_.contact.empty()) {
      return bug(fmt::format("This place, {}, is not critical. {}", true_point(), moving));
    }
    const std::vector<PointId> more = others();
    const std::string place = finding_.contact.size() == 2
                                  ? fmt::format("The midpoint of edge {}", names_text(finding_.contact))
                                  : fmt::format("The centre of {}", simplex_text(finding_.contact));
    if (more.empty()) return bug(fmt::format("{} is stationary, and not critical. {}", place, moving));
    return bug(fmt::format("{} is not critical: {} {} lie{} on its sphere, too. {}", place,
                           more.size() == 1 ? "point" : "points", names_text(more), more.size() == 1 ? "s" : "",
                           moving));
  }

  [[nodiscard]] std::string of_manifolds() const {
    const std::string of = finding_.record ? fmt::format(" of {}", true_point()) : "";
    switch (finding_.reason) {
      case FindingReason::kWrongIncidence:
        return bug(fmt::format("What flows from or to it{} is something else.", of));
      case FindingReason::kWrongPolyline:
        return bug(fmt::format("The orbit{} does not go where your line goes.", of));
      case FindingReason::kWrongSurface:
        return bug(fmt::format("The stable surface{} has other pieces.", of));
      case FindingReason::kWrongLambdaList:
        return bug(fmt::format("The directions{} lead elsewhere, or in another order.", of));
      case FindingReason::kWrongConnections:
        return bug(fmt::format("There are other connections{}, or another number of them.", of));
      case FindingReason::kWrongVolume:
        return bug(fmt::format("The volume{} is another one.", of));
      case FindingReason::kWrongUnstableSet:
        return bug(fmt::format("The unstable surface{} has a part that you miss, or lacks one that you have.", of));
      case FindingReason::kWrongPocket:
        return bug("There is no such pocket, or what you say of it is not so.");
      case FindingReason::kTieBreak:
        return convention("Several boundaries are possible here, and you chose another one.", "this is permitted.");
      default:
        return "";
    }
  }

  const Finding& finding_;
  const Truth& truth_;
};

}  // namespace

std::string finding_sentence(const Finding& finding, const Truth& truth) { return Sentence(finding, truth).text(); }

}  // namespace flowcert::certify
