// See gabriel_edges.h.
#include "morse/gabriel_edges.h"

#include <algorithm>
#include <array>

#include "morse/record_finder.h"

namespace flowcert::morse {

GabrielEdges::GabrielEdges(const PointSet& points, const StationaryPoints& stationary,
                           std::span<const VertexIndex> vertex_of)
    : first_(vertex_of.size() + 1, 0) {
  const auto [first, last] = RecordFinder(stationary).range({1, 1});
  const auto ends = [&](std::size_t record) {
    const auto contact = stationary.contact(record);
    const VertexIndex a = vertex_of[points.position_of_row(contact[0])];
    const VertexIndex b = vertex_of[points.position_of_row(contact[1])];
    return std::array{std::min(a, b), std::max(a, b)};
  };
  for (std::size_t record = first; record < last; ++record) ++first_[ends(record)[0] + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  edges_.resize(last - first);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t record = first; record < last; ++record) {
    const auto [v0, v1] = ends(record);
    edges_[next[v0]++] = {v1, static_cast<std::uint32_t>(record)};
  }
}

}  // namespace flowcert::morse
