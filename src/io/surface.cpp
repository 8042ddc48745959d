// How surfaces are chosen, built and written.
//
// A front belongs to only one stable set (FC-STAB-01), so it is forgotten after that set. Samples and the stationary
// points where sets end are kept. The writers are our own, because CGAL's are templates over its own meshes, which this
// layer does not have.
#include "flowcert/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "io/number_text.h"

namespace flowcert {

using namespace io;

namespace {

// ---- Selection ----

constexpr std::string_view kPersistence = "persistence>";
constexpr std::string_view kRadius = "index2-radius<";
constexpr std::string_view kLargestGaps = "largest-gaps=";

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// For each critical point of index 2, by number in StableManifolds: death minus birth of its pair. The point is the
// death of a tunnel or the birth of a void. Gaps are compared by doubles first, and exactly where these are too close.
class Gaps {
 public:
  explicit Gaps(const FlowComplex& complex) : ends_(complex.stationary().critical_counts()[2]) {
    if (ends_.empty()) return;
    values_ = &complex.persistence().squared_distances();
    const std::size_t first = complex.stable().record(0);
    // Every critical point of index 2 is in a pair that does not last (FC-PERS-02).
    for (const PersistencePair& pair : complex.persistence().pairs()) {
      if (pair.dimension == 0 || !pair.death) continue;
      const std::size_t record = pair.dimension == 1 ? *pair.death : pair.birth;
      ends_[record - first] = {pair.birth, *pair.death};
    }
  }

  [[nodiscard]] std::size_t size() const { return ends_.size(); }

  [[nodiscard]] bool is_above(std::size_t i, const Rational& least) const {
    const auto [low, high] = range(i);
    const std::optional<double> nearest = nearest_double(least);
    if (nearest && low > std::nextafter(*nearest, HUGE_VAL)) return true;
    if (nearest && high < std::nextafter(*nearest, -HUGE_VAL)) return false;
    return exact(i) > least;
  }

  // For each gap: whether it is among the n largest. Among equal gaps, the first in the list come first.
  [[nodiscard]] std::vector<bool> among_largest(std::size_t n) const {
    std::vector<bool> chosen(size(), n >= size());
    if (n == 0 || n >= size()) return chosen;
    // At least n gaps are no less than this, so the n largest are among those that may be no less.
    std::vector<double> lows;
    for (std::size_t i = 0; i < size(); ++i) lows.push_back(range(i).first);
    std::ranges::nth_element(lows, lows.begin() + static_cast<std::ptrdiff_t>(n - 1), std::greater<>());
    const double bound = lows[n - 1];
    std::vector<std::pair<Rational, std::size_t>> candidates;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!(range(i).second < bound)) candidates.emplace_back(exact(i), i);
    }
    std::ranges::stable_sort(candidates, [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t k = 0; k < n; ++k) chosen[candidates[k].second] = true;
    return chosen;
  }

 private:
  struct Ends {
    std::size_t birth = 0, death = 0;
  };
  [[nodiscard]] Rational exact(std::size_t i) const {
    return values_->exact(ends_[i].death) - values_->exact(ends_[i].birth);
  }
  // The gap lies between these. What is taken away and added covers the rounding of the sums.
  [[nodiscard]] std::pair<double, double> range(std::size_t i) const {
    const auto &birth = values_->approximation(ends_[i].birth), &death = values_->approximation(ends_[i].death);
    const double gap = death.value - birth.value;
    const double error = death.error + birth.error + (death.value + birth.value) * 0x1p-50;
    return {gap - error, gap + error};
  }

  const SquaredDistances* values_ = nullptr;
  std::vector<Ends> ends_;
};

// ---- Mesh ----

// Samples, and points where the flow ends, by their contact sets. A front is a vertex of its set alone.
class MeshBuilder {
 public:
  explicit MeshBuilder(const PointSet& points) : points_(points) {}

  void add(std::size_t number, const RoundedSegments& set) {
    vertex_of_.assign(set.positions.size(), kNone);
    for (const auto& [samples, front, back] : set.segments) {
      const std::uint32_t start = vertex(set, front), end = vertex(set, back);
      mesh_.triangles.push_back({sample(samples[0]), start, end});
      mesh_.triangles.push_back({sample(samples[1]), end, start});
      mesh_.set_of_triangle.insert(mesh_.set_of_triangle.end(), 2, number);
    }
  }

  [[nodiscard]] SurfaceMesh take() { return std::move(mesh_); }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::uint32_t sample(PointId id) { return end_vertex({id}, {points_[points_.ordinal_of_row(id)], 0}); }

  std::uint32_t vertex(const RoundedSegments& set, std::uint32_t place) {
    const auto& [sphere, end] = set.positions[place];
    if (!end.empty()) return end_vertex(end, sphere);
    if (vertex_of_[place] == kNone) vertex_of_[place] = new_vertex(sphere);
    return vertex_of_[place];
  }

  std::uint32_t end_vertex(const std::vector<PointId>& contact, const RoundedSphere& sphere) {
    const auto [at, is_new] = ends_.try_emplace(contact, kNone);
    if (is_new) at->second = new_vertex(sphere);
    return at->second;
  }

  std::uint32_t new_vertex(const RoundedSphere& sphere) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    // The file formats have signed indices.
    if (next >= static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max())) {
      throw InvalidInput("a surface of more than 2^31 - 1 vertices cannot be written");
    }
    mesh_.vertices.push_back(finite(sphere.center));
    const bool is_finite = std::isfinite(sphere.squared_radius);
    mesh_.squared_distances.push_back(is_finite ? std::optional(sphere.squared_radius) : std::nullopt);
    return next;
  }

  const PointSet& points_;
  std::unordered_map<std::vector<PointId>, std::uint32_t, boost::hash<std::vector<PointId>>> ends_;
  std::vector<std::uint32_t> vertex_of_;  // by place in the set
  SurfaceMesh mesh_;
};

}  // namespace

// ---- Selecting, building, writing ----

SurfaceSelection::SurfaceSelection(const std::vector<std::string>& expressions) {
  for (std::size_t k = 0; k < expressions.size(); ++k) add(expressions[k], k + 1);
}

void SurfaceSelection::add(const std::string& expression, std::size_t option) {
  const LinePlace place = {"--select", option};
  const std::string text = without_blanks(expression);
  const std::string_view rest(text);
  const auto number_behind = [&](std::string_view name) {
    return claimed_number(rest.substr(name.size()), PlainInteger::kExact, place).value;
  };
  if (rest.starts_with(kPersistence)) {
    const Rational bound = number_behind(kPersistence);
    persistence_above_ = persistence_above_ ? std::max(*persistence_above_, bound) : bound;
  } else if (rest.starts_with(kRadius)) {
    const Rational bound = number_behind(kRadius);
    radius_below_ = radius_below_ ? std::min(*radius_below_, bound) : bound;
  } else if (rest.starts_with(kLargestGaps)) {
    const std::size_t count = claimed_count(rest.substr(kLargestGaps.size()), place);
    largest_gaps_ = largest_gaps_ ? std::min(*largest_gaps_, count) : count;
  } else {
    place.reject("none of persistence>X, index2-radius<R and largest-gaps=N: " + in_quotes(expression));
  }
}

std::vector<std::size_t> SurfaceSelection::sets(const FlowComplex& complex) const {
  std::vector<bool> is_chosen(complex.stationary().critical_counts()[2], true);
  if (radius_below_) {
    const Rational& bound = *radius_below_;
    for (std::size_t i = 0; i < is_chosen.size(); ++i) {
      is_chosen[i] = bound > 0 && complex.sphere(complex.stable().record(i)).squared_radius < bound * bound;
    }
  }
  if (persistence_above_ || largest_gaps_) {
    const Gaps gaps(complex);
    const std::vector<bool> is_large = gaps.among_largest(largest_gaps_.value_or(gaps.size()));
    for (std::size_t i = 0; i < is_chosen.size(); ++i) {
      const bool is_long = !persistence_above_ || gaps.is_above(i, *persistence_above_);
      is_chosen[i] = is_chosen[i] && is_large[i] && is_long;
    }
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < is_chosen.size(); ++i) {
    if (is_chosen[i]) chosen.push_back(i);
  }
  return chosen;
}

SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets,
                         const std::function<void(std::size_t, std::size_t)>& progress) {
  MeshBuilder builder(complex.points());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    builder.add(sets[k], complex.stable().rounded_segments(sets[k]));
    if (progress) progress(k + 1, sets.size());
  }
  return builder.take();
}

void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      comment, mesh.vertices.size(), mesh.triangles.size());
  std::string bytes;
  for (const Point& point : mesh.vertices) {
    for (const double coordinate : {point.x, point.y, point.z}) append_little_endian(bytes, coordinate);
  }
  for (const auto& triangle : mesh.triangles) {
    append_little_endian(bytes, std::uint8_t{3});
    for (const std::uint32_t vertex : triangle) append_little_endian(bytes, vertex);
  }
  out << bytes;
}

void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  out << fmt::format("OFF\n# {}\n{} {} 0\n", comment, mesh.vertices.size(), mesh.triangles.size());
  for (const Point& point : mesh.vertices) out << fmt::format("{} {} {}\n", point.x, point.y, point.z);
  for (const auto& [a, b, c] : mesh.triangles) out << fmt::format("3 {} {} {}\n", a, b, c);
}

}  // namespace flowcert
