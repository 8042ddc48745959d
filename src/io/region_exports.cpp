#include "io/region_exports.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/floating_point.h"
#include "io/corner_numbers.h"
#include "io/number_text.h"
#include "morse/stable_regions.h"

namespace flowcert {

using namespace io;

namespace {

using Samples = std::array<PointId, 2>;

// Stationary points with a face of dimension 1, by the samples of the face.
std::map<Samples, std::size_t> records_of_facets(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  std::map<Samples, std::size_t> records;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record).face_dimension == 1) records.emplace(complex.samples_of(record), record);
  }
  return records;
}

// By stationary point: the number of the pocket whose cell has its stable set, or -1.
std::vector<std::int64_t> pocket_of_records(const FlowComplex& complex, const Pockets& pockets) {
  std::vector<std::int64_t> pocket_of(complex.stationary().size(), -1);
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    for (const std::uint32_t record : pockets[number].cell) pocket_of[record] = static_cast<std::int64_t>(number);
  }
  return pocket_of;
}

// The pyramids of the stable sets that are wanted, with two arrays: where each of them flows to, and its sample.
template <typename IsWanted>
UnstructuredGrid pyramids(const FlowComplex& complex, const IsWanted& is_wanted, std::vector<std::int64_t>& limits) {
  StableRegions regions(complex.diagram(), complex.limits());
  CornerNumbers numbers(complex, regions);
  PyramidSet cells;
  std::vector<std::int64_t> corners, samples;
  regions.visit([&](const StableRegion& region) {
    if (!region.limit || !is_wanted(*region.limit)) return;
    corners.clear();
    for (const RegionCorner& corner : region.corners) corners.push_back(numbers.of(region, corner));
    for (const std::size_t side : {1U, 0U}) {
      const PointId sample = region.samples[side];
      const std::size_t count = cells.append(corners, numbers.of_sample(sample));
      limits.insert(limits.end(), count, static_cast<std::int64_t>(*region.limit));
      samples.insert(samples.end(), count, static_cast<std::int64_t>(sample));
      std::ranges::reverse(corners);
    }
  });
  UnstructuredGrid grid = cells.take();
  grid.points = numbers.take_points();
  grid.cell_data.push_back({"maximum", limits});
  grid.cell_data.push_back({"sample", std::move(samples)});
  return grid;
}

}  // namespace

UnstructuredGrid stable_cell_data(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  std::vector<std::int64_t> limits;
  UnstructuredGrid grid = pyramids(complex, [](std::size_t) { return true; }, limits);
  std::vector<double> volumes;
  volumes.reserve(limits.size());
  for (const std::int64_t limit : limits) {
    volumes.push_back(finite(complex.volumes().nearest(static_cast<std::size_t>(limit))));
  }
  grid.cell_data.push_back({"volume", std::move(volumes)});
  return grid;
}

UnstructuredGrid pocket_cell_data(const FlowComplex& complex, const Pockets& pockets) {
  const geometry::IeeeDoubles ieee;
  const std::vector<std::int64_t> pocket_of = pocket_of_records(complex, pockets);
  std::vector<std::int64_t> limits, numbers;
  UnstructuredGrid grid = pyramids(complex, [&](std::size_t limit) { return pocket_of[limit] >= 0; }, limits);
  std::vector<double> volumes, depths;
  std::vector<double> volume_of, depth_of;
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    volume_of.push_back(finite(complex.volumes().nearest_sum(pockets[number].cell)));
    depth_of.push_back(finite(pockets.depth(pockets[number])));
  }
  for (const std::int64_t limit : limits) {
    numbers.push_back(pocket_of[static_cast<std::size_t>(limit)]);
    volumes.push_back(volume_of[static_cast<std::size_t>(numbers.back())]);
    depths.push_back(depth_of[static_cast<std::size_t>(numbers.back())]);
  }
  grid.cell_data.push_back({"pocket", std::move(numbers)});
  grid.cell_data.push_back({"volume", std::move(volumes)});
  grid.cell_data.push_back({"depth", std::move(depths)});
  return grid;
}

PolyData unstable_fan_data(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  StableRegions regions(complex.diagram(), complex.limits());
  CornerNumbers numbers(complex, regions);
  const std::map<Samples, std::size_t> records = records_of_facets(complex);
  PolyData data;
  std::vector<std::int64_t> limits, samples, sources;
  regions.visit([&](const StableRegion& region) {
    const auto source = records.find(region.samples);
    const auto is_end = [](const RegionCorner& corner) { return corner.kind == RegionCorner::Kind::kEnd; };
    if (source == records.end() || region.corners.empty() || std::ranges::any_of(region.corners, is_end)) return;
    auto& connectivity = data.polygons.connectivity;
    for (const RegionCorner& corner : region.corners) connectivity.push_back(numbers.of(region, corner));
    data.polygons.offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    limits.push_back(region.limit ? static_cast<std::int64_t>(*region.limit) : -1);
    for (const PointId sample : region.samples) samples.push_back(static_cast<std::int64_t>(sample));
    sources.push_back(static_cast<std::int64_t>(source->second));
  });
  data.points = numbers.take_points();
  data.cell_data.push_back({"limit", std::move(limits)});
  data.cell_data.push_back({"samples", std::move(samples), 2});
  data.cell_data.push_back({"source", std::move(sources)});
  return data;
}

}  // namespace flowcert
