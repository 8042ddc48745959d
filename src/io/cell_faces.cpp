// A cell consists of pyramids over the regions of facets. Each side of a pyramid, with the sample as a corner, is a
// side of just one other pyramid with this sample: over the next region of the facet, or, if it stands on a Voronoi
// edge, over a region of the next facet around that. So sides meet two by two, and those of two cells are the faces.
#include "io/cell_faces.h"

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "io/corner_numbers.h"
#include "morse/stable_regions.h"

namespace flowcert::io {

namespace {

// A side of a region that waits for the one on its other side.
using SideKey = std::array<std::uint32_t, 2>;
struct OpenSide {
  SideKey side;  // the region's sense: counterclockwise, seen from samples[1]
  std::uint32_t limit;
};

class FaceMaker {
 public:
  FaceMaker(const FlowComplex& complex, const std::vector<bool>& is_wanted)
      : is_wanted_(is_wanted), regions_(complex.diagram(), complex.limits()), numbers_(complex, regions_) {}

  [[nodiscard]] CellFaces made() && {
    regions_.visit([this](const StableRegion& region) { add(region); });
    leave_facet();
    for (const auto& [key, other] : open_) {
      if (wants(other.limit)) throw std::logic_error("a side of a pyramid with nothing on its other side");
    }
    CellFaces made;
    for (auto& [limits, triangles] : faces_) made.faces.push_back({limits, std::move(triangles)});
    keep_corners(made);
    return made;
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  [[nodiscard]] bool wants(std::uint32_t limit) const { return limit != CellFace::kInfinity && is_wanted_[limit]; }

  void add(const StableRegion& region) {
    if (region.samples != samples_) leave_facet();
    samples_ = region.samples;
    const std::uint32_t limit = region.limit ? static_cast<std::uint32_t>(*region.limit) : CellFace::kInfinity;
    const std::size_t n = region.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const RegionCorner &from = region.corners[i], &to = region.corners[(i + 1) % n];
      if (from.kind == RegionCorner::Kind::kEnd || to.kind == RegionCorner::Kind::kEnd) continue;
      add_side({{number_of(region, from), number_of(region, to)}, limit});
    }
  }
  [[nodiscard]] std::uint32_t number_of(const StableRegion& region, const RegionCorner& corner) {
    return static_cast<std::uint32_t>(numbers_.of(region, corner));
  }

  // Sides within the facet are rays from its midpoint.
  void add_side(const OpenSide& side) {
    if (side.side[0] == side.side[1]) return;
    const auto is_other = [&](const OpenSide& other) {
      return other.side[0] == side.side[1] && other.side[1] == side.side[0];
    };
    const auto other = std::ranges::find_if(sides_, is_other);
    if (other == sides_.end()) return sides_.push_back(side);
    if (other->limit != side.limit) {
      for (const PointId sample : samples_) {
        separate(side.limit, other->limit, outer_triangle(side, sample));
      }
    }
    *other = sides_.back();
    sides_.pop_back();
  }

  // All other sides are on Voronoi edges, and the next facets around these have them, too.
  void leave_facet() {
    for (const OpenSide& side : sides_) {
      for (const PointId sample : samples_) {
        const Triangle triangle = outer_triangle(side, sample);
        const Triangle key = {std::min(triangle[0], triangle[1]), std::max(triangle[0], triangle[1]), sample};
        const auto [found, is_first] = open_.try_emplace(key, OpenSide{{triangle[0], triangle[1]}, side.limit});
        if (is_first) continue;
        if (found->second.limit != side.limit) separate(side.limit, found->second.limit, triangle);
        open_.erase(found);
      }
    }
    sides_.clear();
  }

  // As it is seen from outside of the pyramid with this apex.
  [[nodiscard]] Triangle outer_triangle(const OpenSide& side, PointId sample) {
    const bool is_above = sample == samples_[1];
    return {side.side[is_above ? 0 : 1], side.side[is_above ? 1 : 0], sample};
  }

  // Those of the triangles alone, which are in the hull of the samples. Others can be beyond all doubles.
  void keep_corners(CellFaces& made) const {
    std::unordered_map<std::uint32_t, std::uint32_t> kept;
    for (CellFace& face : made.faces) {
      for (Triangle& triangle : face.triangles) {
        for (std::uint32_t& corner : triangle) {
          const auto [found, is_new] = kept.try_emplace(corner, static_cast<std::uint32_t>(made.corners.size()));
          if (is_new) made.corners.push_back(numbers_.position(corner));
          corner = found->second;
        }
      }
    }
  }

  void separate(std::uint32_t inner, std::uint32_t outer, Triangle triangle) {
    if (!wants(inner) && !wants(outer)) return;
    if (inner > outer) std::swap(inner, outer), std::swap(triangle[0], triangle[1]);
    triangle[2] = static_cast<std::uint32_t>(numbers_.of_sample(triangle[2]));
    faces_[{inner, outer}].push_back(triangle);
  }

  const std::vector<bool>& is_wanted_;
  StableRegions regions_;
  CornerNumbers numbers_;
  std::array<PointId, 2> samples_{};
  std::vector<OpenSide> sides_;  // of the facet at hand
  std::unordered_map<Triangle, OpenSide, boost::hash<Triangle>> open_;
  std::map<std::array<std::uint32_t, 2>, std::vector<Triangle>> faces_;
};

}  // namespace

CellFaces cell_faces(const FlowComplex& complex, const std::vector<bool>& is_wanted) {
  if (std::ranges::find(is_wanted, true) == is_wanted.end()) return {};
  return FaceMaker(complex, is_wanted).made();
}

}  // namespace flowcert::io
