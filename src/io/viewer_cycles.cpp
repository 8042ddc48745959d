// Chains are made at whole percents of the way from birth to death. One that is the same at two levels is the same
// between them, so that halving finds where they change.
#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "flowcert/loops.h"
#include "flowcert/surface.h"
#include "flowcert/voids.h"
#include "geometry/parallel_for.h"
#include "io/cell_faces.h"
#include "io/viewer_parts.h"
#include "morse/longest_pairs.h"

namespace flowcert::io {

namespace {

constexpr std::uint32_t kNone = ViewerSelection::kNone;
constexpr std::uint8_t kDeath = 100;
using Numbers = std::vector<std::uint32_t>;
using Chain = ViewerCycle::Chain;

// ---- What stands for each pair ----

// Appends the chains below the percent `high`, down to that of `low`.
template <class ChainAt>
void descend(const ChainAt& chain_at, ViewerCycle::Step low, const ViewerCycle::Step& high,
             std::vector<ViewerCycle::Step>& steps) {
  if (low.chain == high.chain) return;
  if (high.percent - low.percent == 1) return steps.push_back(std::move(low));
  const auto percent = static_cast<std::uint8_t>((low.percent + high.percent) / 2);
  const ViewerCycle::Step middle = {percent, chain_at(percent)};
  descend(chain_at, middle, high, steps);
  descend(chain_at, std::move(low), middle, steps);
}

class ChainMaker {
 public:
  explicit ChainMaker(const FlowComplex& complex)
      : values_(complex.persistence().squared_distances()),
        trees_(complex.merge_trees()),
        loops_(complex.stationary(), complex.links(), complex.persistence()),
        voids_(trees_),
        parents_(trees_.pockets().parents()) {}

  [[nodiscard]] ViewerCycle of(const PersistencePair& pair) const {
    const auto chain_at = [&](std::uint8_t percent) {
      return pair.dimension == 1 ? loop(pair, percent) : space(pair, percent);
    };
    const ViewerCycle::Step death = {kDeath, chain_at(kDeath)};
    ViewerCycle cycle = {pair, {death}};
    descend(chain_at, {0, chain_at(0)}, death, cycle.steps);
    return cycle;
  }

 private:
  [[nodiscard]] SquaredLevel level(const PersistencePair& pair, std::uint8_t percent) const {
    return {values_, pair.birth, *pair.death, Rational(percent, 100)};
  }
  // At the death, here and below, what is there at all levels right below it.
  [[nodiscard]] Chain loop(const PersistencePair& pair, std::uint8_t percent) const {
    Numbers surface = percent == kDeath ? Numbers{*pair.death} : loops_.surface(pair, level(pair, percent));
    Numbers edges = loops_.boundary(surface);
    return {std::move(surface), std::move(edges), {}, {}};
  }
  [[nodiscard]] Chain space(const PersistencePair& pair, std::uint8_t percent) const {
    const MergeTree& tree = trees_.pockets();
    const std::size_t leaf = *pair.death - trees_.record_of(0);
    const std::uint32_t gate = tree.nodes[parents_[leaf] - tree.leaves].points.front();
    Void found =
        voids_.at(*pair.death, percent == kDeath ? SquaredLevel(values_, gate, gate, 0) : level(pair, percent));
    return {std::move(found.walls), {}, std::move(found.maxima), std::move(found.cell)};
  }

  const SquaredDistances& values_;
  const MergeTrees& trees_;
  Loops loops_;
  Voids voids_;
  Numbers parents_;
};

// ---- Their surfaces, in pieces ----

std::size_t first_saddle_of(const FlowComplex& complex) {
  return complex.stationary().critical_counts()[0] + complex.stationary().critical_counts()[1];
}

// Whether the S2 of its walls are all that bounds a void: each of them is, if its two sides lead to the inside and to
// the outside alone; and no other stationary point leads to both.
class WallsCheck {
 public:
  explicit WallsCheck(const FlowComplex& complex) : trees_(complex.merge_trees()) {
    const std::size_t first_saddle = first_saddle_of(complex);
    for (std::uint32_t record = 0; record < complex.stationary().size(); ++record) {
      const StationaryIndex index = complex.stationary().index(record);
      if (index == StationaryIndex{1, 1}) continue;
      if (index == StationaryIndex{2, 2} && !complex.stable().has_interval(record - first_saddle)) {
        for (const auto side : trees_.peaks_above_sides(record)) {
          if (side.size() > 1) doubtful_.emplace_back(side.begin(), side.end());
        }
      } else if (Numbers peaks = trees_.peaks_above(record); peaks.size() > 1) {
        doubtful_.push_back(std::move(peaks));
      }
    }
  }

  [[nodiscard]] bool holds(const Numbers& maxima) const {
    const auto is_inside = [&](std::uint32_t leaf) {
      return std::ranges::binary_search(maxima, static_cast<std::uint32_t>(trees_.record_of(leaf)));
    };
    return std::ranges::all_of(doubtful_, [&](const Numbers& peaks) {
      return std::ranges::all_of(peaks, is_inside) || std::ranges::none_of(peaks, is_inside);
    });
  }

 private:
  const MergeTrees& trees_;
  std::vector<Numbers> doubtful_;  // leaves
};

// The surfaces S2 of the page, and behind them what the page has for these chains alone. Its vertices are those of S2,
// and others behind them.
class Pieces {
 public:
  Pieces(const FlowComplex& complex, const ViewerFrame& frame, const ViewerSelection& selection,
         const std::vector<float>& s2_vertices)
      : complex_(complex),
        frame_(frame),
        s2_vertices_(s2_vertices),
        s2_(complex.stationary().size(), kNone),
        next_(static_cast<std::uint32_t>(selection.sets.size())) {
    for (std::size_t k = 0; k < selection.sets.size(); ++k) {
      s2_[complex.stable().record(selection.sets[k])] = static_cast<std::uint32_t>(k);
    }
    add_tied(selection.cycles);
    add_faces(selection.cycles);
  }

  // Ascending. One is none where the page does not have it.
  [[nodiscard]] Numbers of(const Chain& chain) const {
    if (const auto found = faces_of_.find(chain.cell); found != faces_of_.end()) return found->second;
    Numbers pieces;
    for (const std::uint32_t saddle : chain.surface) {
      const auto tied = chain.cell.empty() ? tied_.find(saddle) : tied_.end();
      pieces.push_back(tied == tied_.end() ? s2_[saddle] : tied->second);
    }
    std::ranges::sort(pieces);
    return pieces;
  }

  void put(Json& json) const {
    json["triangle_offsets"] = viewer_blob(offsets_);
    json["triangles"] = viewer_blob(triangles_);
    json["vertices"] = viewer_blob(vertices_);
  }

 private:
  template <class Triangles>
  std::uint32_t add(const Triangles& triangles, const std::vector<Point>& vertices) {
    for (const auto& triangle : triangles) {
      for (const std::uint32_t vertex : triangle) triangles_.push_back(vertex_number(vertices[vertex]));
    }
    offsets_.push_back(static_cast<std::uint32_t>(triangles_.size() / 3));
    return next_++;
  }

  std::uint32_t vertex_number(const Point& vertex) {
    const auto place = [](std::size_t floats) { return static_cast<std::uint32_t>(floats / 3); };
    if (numbers_.empty()) {
      for (std::size_t k = 0; k < s2_vertices_.size(); k += 3) {
        numbers_.try_emplace({s2_vertices_[k], s2_vertices_[k + 1], s2_vertices_[k + 2]}, place(k));
      }
    }
    std::array<float, 3> at{};
    std::ranges::transform(frame_.placed(vertex), at.begin(), [](double x) { return static_cast<float>(x); });
    const auto [found, is_new] = numbers_.try_emplace(at, place(s2_vertices_.size() + vertices_.size()));
    if (is_new) vertices_.insert(vertices_.end(), at.begin(), at.end());
    return found->second;
  }

  // Below a tie, an S2 need not have the boundary that the chain takes (FC-CHAIN-02).
  void add_tied(const std::vector<ViewerCycle>& cycles) {
    const std::size_t first_saddle = first_saddle_of(complex_);
    const bool has_regular = complex_.stable().size() > complex_.stationary().critical_counts()[2];
    std::set<std::uint32_t> seen;
    for (const ViewerCycle& cycle : cycles) {
      for (const ViewerCycle::Step& step : cycle.steps) {
        for (const std::uint32_t saddle : step.chain.cell.empty() ? step.chain.surface : Numbers{}) {
          if (!has_regular && !complex_.stable().has_vertex(saddle - first_saddle)) continue;
          if (!seen.insert(saddle).second) continue;
          const SurfaceMesh part = loop_surface_mesh(complex_, std::array{saddle});
          const SurfaceMesh whole = surface_mesh(complex_, std::array{saddle - first_saddle});
          if (part.triangles == whole.triangles && part.vertices == whole.vertices) continue;
          tied_[saddle] = add(part.triangles, part.vertices);
        }
      }
    }
  }

  void add_faces(const std::vector<ViewerCycle>& cycles) {
    const WallsCheck walls(complex_);
    std::vector<Numbers> cells_with(complex_.stationary().size());  // by record: places in `of_cell`, ascending
    std::vector<bool> is_wanted(complex_.stationary().size(), false);
    std::vector<Numbers*> of_cell;
    for (const ViewerCycle& cycle : cycles) {
      for (const auto& [percent, chain] : cycle.steps) {
        if (chain.cell.empty() || walls.holds(chain.maxima)) continue;
        const auto [found, is_new] = faces_of_.try_emplace(chain.cell);
        if (!is_new) continue;
        for (const std::uint32_t record : chain.cell) {
          cells_with[record].push_back(static_cast<std::uint32_t>(of_cell.size()));
          is_wanted[record] = true;
        }
        of_cell.push_back(&found->second);
      }
    }
    if (of_cell.empty()) return;
    const CellFaces made = cell_faces(complex_, is_wanted);
    auto sets_between = separating_sets();
    for (const CellFace& face : made.faces) {
      std::array<Numbers, 2> sides;
      for (const std::size_t side : {0U, 1U}) {
        if (face.limits[side] != CellFace::kInfinity) sides[side] = cells_with[face.limits[side]];
      }
      Numbers between;
      std::ranges::set_symmetric_difference(sides[0], sides[1], std::back_inserter(between));
      if (between.empty()) continue;
      const Numbers pieces = pieces_of(face, made.corners, sets_between[face.limits]);
      for (const std::uint32_t cell : between)
        of_cell[cell]->insert(of_cell[cell]->end(), pieces.begin(), pieces.end());
    }
    for (Numbers* pieces : of_cell) std::ranges::sort(*pieces);
  }

  // A face is often some S2 and nothing else, which the page has.
  Numbers pieces_of(const CellFace& face, const std::vector<Point>& corners, const Numbers& sets) {
    Numbers pieces;
    std::size_t triangles = 0;
    for (const std::uint32_t set : sets) {
      pieces.push_back(s2_[complex_.stable().record(set)]);
      triangles += 2 * complex_.stable().segment_count(set);
    }
    if (triangles != face.triangles.size()) pieces = {add(face.triangles, corners)};
    return pieces;
  }

  // By number in StableManifolds, those that separate two maxima, or one from infinity.
  [[nodiscard]] std::map<std::array<std::uint32_t, 2>, Numbers> separating_sets() const {
    const UnstableManifolds& u2 = complex_.unstable();
    std::map<std::array<std::uint32_t, 2>, Numbers> found;
    for (std::uint32_t set = 0; set < u2.size(); ++set) {
      std::array<std::uint32_t, 2> ends{};
      bool is_separating = !complex_.stable().has_interval(set);
      for (const std::size_t side : {0U, 1U}) {
        const auto limit = u2.limit(set, side);
        ends[side] = limit ? static_cast<std::uint32_t>(*limit) : CellFace::kInfinity;
        is_separating = is_separating && (!limit || complex_.stationary().index(*limit) == StationaryIndex{3, 3});
      }
      std::ranges::sort(ends);
      if (is_separating && ends[0] != ends[1]) found[ends].push_back(set);
    }
    return found;
  }

  const FlowComplex& complex_;
  const ViewerFrame& frame_;
  const std::vector<float>& s2_vertices_;
  Numbers s2_;                                   // by record
  std::uint32_t next_;                           // the number of the next piece
  std::map<std::uint32_t, std::uint32_t> tied_;  // by record
  std::map<Numbers, Numbers> faces_of_;          // by the cells that their walls alone do not bound
  Numbers offsets_ = {0}, triangles_;
  std::vector<float> vertices_;
  std::unordered_map<std::array<float, 3>, std::uint32_t, boost::hash<std::array<float, 3>>> numbers_;
};

// Lists of lists, each as what it does not have in common with the one before.
struct Changes {
  Numbers offsets = {0}, all, last;

  void begin() { last.clear(); }
  void add(Numbers list) {
    std::ranges::set_symmetric_difference(last, list, std::back_inserter(all));
    offsets.push_back(static_cast<std::uint32_t>(all.size()));
    last = std::move(list);
  }
};

}  // namespace

std::vector<ViewerCycle> viewer_cycles(const FlowComplex& complex, const std::vector<const PersistencePair*>& pairs) {
  constexpr std::size_t kMost = 100;
  std::vector<PersistencePair> chosen;
  for (const int dimension : {1, 2}) {
    std::vector<PersistencePair> of_dimension;
    for (const PersistencePair* pair : pairs) {
      if (pair->dimension == dimension && pair->death) of_dimension.push_back(*pair);
    }
    std::ranges::copy(longest_pairs(complex.persistence().squared_distances(), of_dimension, kMost),
                      std::back_inserter(chosen));
  }
  if (chosen.empty()) return {};
  const ChainMaker maker(complex);
  std::vector<ViewerCycle> cycles(chosen.size());
  geometry::parallel_for(chosen.size(), complex.threads(), [&](std::size_t k) { cycles[k] = maker.of(chosen[k]); });
  return cycles;
}

Json viewer_cycles_field(const FlowComplex& complex, const ViewerFrame& frame, const ViewerSelection& selection,
                         const std::vector<float>& s2_vertices) {
  const Pieces pieces(complex, frame, selection, s2_vertices);
  Numbers pairs, step_offsets = {0};
  std::vector<std::uint8_t> percents, least;
  Changes surfaces, edges;
  for (const ViewerCycle& cycle : selection.cycles) {
    surfaces.begin(), edges.begin();
    std::uint8_t lowest = 0;
    for (const auto& [percent, chain] : cycle.steps) {
      Numbers of_surface = pieces.of(chain), of_loop;
      for (const std::uint32_t edge : chain.edges) of_loop.push_back(selection.place[edge]);
      std::ranges::sort(of_loop);
      if (of_surface.back() == kNone || (!of_loop.empty() && of_loop.back() == kNone)) {
        lowest = percent + 1;
        break;
      }
      percents.push_back(percent);
      surfaces.add(std::move(of_surface));
      edges.add(std::move(of_loop));
    }
    if (lowest > kDeath) continue;
    const auto has_birth = [&](const PersistencePair* pair) {
      return pair->dimension == cycle.pair.dimension && pair->birth == cycle.pair.birth;
    };
    pairs.push_back(
        static_cast<std::uint32_t>(std::ranges::find_if(selection.pairs, has_birth) - selection.pairs.begin()));
    least.push_back(lowest);
    step_offsets.push_back(static_cast<std::uint32_t>(percents.size()));
  }
  Json json;
  json["pair"] = viewer_blob(pairs);
  json["least"] = viewer_blob(least);
  json["step_offsets"] = viewer_blob(step_offsets);
  json["percent"] = viewer_blob(percents);
  json["piece_offsets"] = viewer_blob(surfaces.offsets);
  json["pieces"] = viewer_blob(surfaces.all);
  json["edge_offsets"] = viewer_blob(edges.offsets);
  json["edges"] = viewer_blob(edges.all);
  pieces.put(json);
  return json;
}

}  // namespace flowcert::io
