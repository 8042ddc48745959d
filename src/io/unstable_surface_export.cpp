// Sets are made by several threads, and spooled in their order.
#include "io/unstable_surface_export.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "flowcert/unstable_surfaces.h"
#include "geometry/floating_point.h"
#include "geometry/parallel_for.h"
#include "geometry/rational_point.h"
#include "io/byte_spool.h"
#include "io/clip_box.h"
#include "io/number_text.h"
#include "io/ply_header.h"
#include "io/vtk_document.h"

namespace flowcert {

using namespace io;

namespace {

using Kind = RoundedUnstableSurface::Kind;

struct SurfaceCell {
  Kind kind;
  std::vector<PointId> samples;
  std::vector<std::uint32_t> points;
};

// One set as the files have it, its points numbered from 0.
struct SurfacePicture {
  std::vector<Point> points;
  std::vector<bool> is_clipped;
  std::vector<SurfaceCell> cells;
};

class PictureMaker {
 public:
  PictureMaker(const RoundedUnstableSurface& surface, const std::optional<ClipBox>& box)
      : surface_(surface), box_(box), number_of_(surface.corners.size(), kNone) {}

  [[nodiscard]] SurfacePicture make() && {
    for (const RoundedUnstableSurface::Part& part : surface_.parts) {
      std::vector<std::uint32_t> points = is_whole(part) ? numbers(part) : cut_numbers(part);
      if (points.empty() || (part.kind == Kind::kSheet && points.size() < 3)) continue;
      if (points.size() == 1 && part.corners.size() > 1) continue;
      picture_.cells.push_back({part.kind, part.samples, std::move(points)});
    }
    return std::move(picture_);
  }

 private:
  static constexpr std::uint32_t kNone = ProjectiveCorner::kNone;

  [[nodiscard]] bool is_whole(const RoundedUnstableSurface::Part& part) const {
    return std::ranges::all_of(part.corners, [&](std::uint32_t number) {
      const auto& corner = surface_.corners[number];
      return !corner.at_infinity && (!box_ || box_->contains(corner.position));
    });
  }
  [[nodiscard]] std::vector<std::uint32_t> numbers(const RoundedUnstableSurface::Part& part) {
    std::vector<std::uint32_t> points;
    points.reserve(part.corners.size());
    for (const std::uint32_t corner : part.corners) points.push_back(number(corner));
    return points;
  }
  // Of what the box leaves; nothing without a box.
  [[nodiscard]] std::vector<std::uint32_t> cut_numbers(const RoundedUnstableSurface::Part& part) {
    if (!box_) return {};
    std::vector<ProjectiveCorner> corners;
    for (const std::uint32_t each : part.corners) {
      const auto& [position, at_infinity, exact] = surface_.corners[each];
      const RationalPoint x = exact ? *exact : geometry::exact_position(position);
      corners.push_back(at_infinity ? corner_at_infinity(x, each) : finite_corner(x, each));
    }
    const Outline outline = part.kind == Kind::kSheet ? Outline::kClosed : Outline::kOpen;
    corners = clipped(std::move(corners), outline, *box_);
    // The middle of a whole line is no end of it.
    if (outline == Outline::kOpen && corners.size() > 2) corners.erase(corners.begin() + 1, corners.end() - 1);
    std::vector<std::uint32_t> points;
    for (const ProjectiveCorner& corner : corners) {
      const std::uint32_t next = corner.number != kNone ? number(corner.number) : number_of_cut(rounded(corner.x));
      if (points.empty() || points.back() != next) points.push_back(next);
    }
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    return points;
  }

  std::uint32_t number(std::uint32_t corner) {
    std::uint32_t& number = number_of_[corner];
    if (number == kNone) number = append(finite(surface_.corners[corner].position), false);
    return number;
  }
  std::uint32_t number_of_cut(const Point& position) {
    const auto [known, is_new] = cuts_.try_emplace(position.coordinates(), kNone);
    if (is_new) known->second = append(position, true);
    return known->second;
  }
  std::uint32_t append(const Point& position, bool is_clipped) {
    picture_.points.push_back(position);
    picture_.is_clipped.push_back(is_clipped);
    return static_cast<std::uint32_t>(picture_.points.size() - 1);
  }

  const RoundedUnstableSurface& surface_;
  const std::optional<ClipBox>& box_;
  SurfacePicture picture_;
  std::vector<std::uint32_t> number_of_;
  std::map<std::array<double, 3>, std::uint32_t> cuts_;
};

}  // namespace

struct UnstableSurfaceExport::Parts {
  // Vertices, lines and polygons are cells of their own in a VTP file.
  struct Cells {
    explicit Cells(const std::string& folder)
        : connectivity(folder), offsets(folder), sources(folder), kinds(folder), samples(folder) {}

    ByteSpool connectivity, offsets, sources, kinds, samples;
    std::int64_t count = 0, corners = 0;
  };

  Parts(const std::string& folder, bool is_clipped_at_box)
      : has_box(is_clipped_at_box),
        points(folder),
        is_clipped(folder),
        cells{Cells(folder), Cells(folder), Cells(folder)},
        triangles(folder) {}

  void append(const SurfacePicture& picture, std::size_t source);
  void append(const SurfaceCell& cell, std::int64_t source, std::int64_t first_point);
  void write_cell_data(VtkDocument& document, const char* name, const char* type, int components,
                       ByteSpool Cells::* spool) const;

  bool has_box;
  ByteSpool points, is_clipped;
  std::array<Cells, 3> cells;
  ByteSpool triangles;  // as PLY has them
  std::int64_t point_count = 0, triangle_count = 0;
};

void UnstableSurfaceExport::Parts::append(const SurfacePicture& picture, std::size_t source) {
  for (const SurfaceCell& cell : picture.cells) append(cell, static_cast<std::int64_t>(source), point_count);
  for (const Point& point : picture.points) {
    for (const double coordinate : point.coordinates()) points.append(coordinate);
  }
  for (const bool is_cut : picture.is_clipped) is_clipped.append(static_cast<std::int8_t>(is_cut));
  point_count += static_cast<std::int64_t>(picture.points.size());
}

// Triangles are a fan from the first corner. Where there are too many points for their numbers, no PLY is written.
void UnstableSurfaceExport::Parts::append(const SurfaceCell& cell, std::int64_t source, std::int64_t first_point) {
  const auto& corners = cell.points;
  Cells& to = cells[cell.kind == Kind::kSheet ? 2 : corners.size() == 1 ? 0 : 1];
  for (const std::uint32_t corner : corners) to.connectivity.append(first_point + std::int64_t{corner});
  to.corners += static_cast<std::int64_t>(corners.size());
  to.offsets.append(to.corners);
  to.sources.append(source);
  to.kinds.append(static_cast<std::int8_t>(cell.kind));
  for (std::size_t k = 0; k < 3; ++k) {
    to.samples.append(k < cell.samples.size() ? static_cast<std::int64_t>(cell.samples[k]) : std::int64_t{-1});
  }
  ++to.count;
  if (cell.kind != Kind::kSheet) return;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    triangles.append(std::uint8_t{3});
    for (const std::uint32_t corner : {corners[0], corners[k], corners[k + 1]}) {
      triangles.append(static_cast<std::int32_t>(first_point + std::int64_t{corner}));
    }
    ++triangle_count;
  }
}

UnstableSurfaceExport::UnstableSurfaceExport(const FlowComplex& complex, const std::optional<ClipBox>& box,
                                             const std::string& folder, const Progress& progress,
                                             const std::vector<std::size_t>* records)
    : parts_(std::make_unique<Parts>(folder, box.has_value())) {
  const geometry::IeeeDoubles ieee;
  const UnstableSurfaces surfaces(complex.diagram(), complex.stationary());
  const unsigned threads = complex.threads();
  std::vector<SurfacePicture> pictures(threads <= 1 ? 1 : 16 * std::size_t{threads});
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!records || std::ranges::binary_search(*records, surfaces.record(i))) wanted.push_back(i);
  }
  for (std::size_t begun = 0; begun < wanted.size(); begun += pictures.size()) {
    const std::size_t count = std::min(pictures.size(), wanted.size() - begun);
    geometry::parallel_for(count, threads, [&](std::size_t k) {
      pictures[k] = PictureMaker(surfaces.rounded_set(wanted[begun + k]), box).make();
    });
    for (std::size_t k = 0; k < count; ++k) parts_->append(pictures[k], surfaces.record(wanted[begun + k]));
    if (progress) progress(begun + count, wanted.size());
  }
}

UnstableSurfaceExport::~UnstableSurfaceExport() = default;

// ---- Data ----

namespace {

template <typename Number>
void append_numbers(std::vector<Number>& numbers, const ByteSpool& spool) {
  std::ostringstream out;
  spool.copy_to(out);
  const std::string bytes = std::move(out).str();
  for (std::size_t k = 0; k < bytes.size(); k += sizeof(Number)) {
    const std::uint64_t bits = stored_bits(bytes.data() + k, sizeof(Number), false);
    if constexpr (sizeof(Number) == 1) {
      numbers.push_back(static_cast<Number>(static_cast<std::uint8_t>(bits)));
    } else {
      numbers.push_back(std::bit_cast<Number>(bits));
    }
  }
}

template <typename Number>
std::vector<Number> numbers_of(const ByteSpool& spool) {
  std::vector<Number> numbers;
  append_numbers(numbers, spool);
  return numbers;
}

}  // namespace

PolyData UnstableSurfaceExport::data() const {
  const Parts& all = *parts_;
  PolyData data;
  const std::vector<double> coordinates = numbers_of<double>(all.points);
  for (std::size_t k = 0; k < coordinates.size(); k += 3) {
    data.points.push_back({coordinates[k], coordinates[k + 1], coordinates[k + 2]});
  }
  if (all.has_box) data.point_data.push_back({"IsClipped", numbers_of<std::int8_t>(all.is_clipped)});
  const std::array<VtpCells*, 3> cells = {&data.vertices, &data.lines, &data.polygons};
  std::vector<std::int8_t> kinds;
  std::vector<std::int64_t> samples, sources;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Parts::Cells& each = all.cells[k];
    *cells[k] = {numbers_of<std::int64_t>(each.connectivity), numbers_of<std::int64_t>(each.offsets)};
    append_numbers(kinds, each.kinds);
    append_numbers(samples, each.samples);
    append_numbers(sources, each.sources);
  }
  data.cell_data.push_back({"kind", std::move(kinds)});
  data.cell_data.push_back({"samples", std::move(samples), 3});
  data.cell_data.push_back({"source", std::move(sources)});
  return data;
}

// ---- Files ----

namespace {

void write_spool(VtkDocument& document, const char* name, const char* type, int components, const ByteSpool& spool) {
  document.array(name, type, components, spool.size(), [&spool](std::ostream& out) { spool.copy_to(out); });
}

}  // namespace

void UnstableSurfaceExport::Parts::write_cell_data(VtkDocument& document, const char* name, const char* type,
                                                   int components, ByteSpool Cells::* spool) const {
  std::uint64_t bytes = 0;
  for (const Cells& each : cells) bytes += (each.*spool).size();
  document.array(name, type, components, bytes, [this, spool](std::ostream& out) {
    for (const Cells& each : cells) (each.*spool).copy_to(out);
  });
}

void UnstableSurfaceExport::write_vtp(std::ostream& out, const std::string& comment) const {
  const geometry::IeeeDoubles ieee;
  const Parts& all = *parts_;
  const auto count = [](std::int64_t number) { return static_cast<std::size_t>(number); };
  VtkDocument document(out, "PolyData", comment);
  document.piece({.points = count(all.point_count),
                  .vertices = count(all.cells[0].count),
                  .lines = count(all.cells[1].count),
                  .polygons = count(all.cells[2].count)});
  document.begin("PointData");
  if (all.has_box) write_spool(document, "IsClipped", "Int8", 1, all.is_clipped);
  document.end("PointData");
  document.begin("CellData");
  all.write_cell_data(document, "kind", "Int8", 1, &Parts::Cells::kinds);
  all.write_cell_data(document, "samples", "Int64", 3, &Parts::Cells::samples);
  all.write_cell_data(document, "source", "Int64", 1, &Parts::Cells::sources);
  document.end("CellData");
  document.begin("Points");
  write_spool(document, "Points", "Float64", 3, all.points);
  document.end("Points");
  constexpr std::array<const char*, 3> kNames = {"Verts", "Lines", "Polys"};
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    document.begin(kNames[k]);
    write_spool(document, "connectivity", "Int64", 1, all.cells[k].connectivity);
    write_spool(document, "offsets", "Int64", 1, all.cells[k].offsets);
    document.end(kNames[k]);
  }
  document.end();
}

void UnstableSurfaceExport::write_ply(std::ostream& out, const std::string& comment) const {
  const geometry::IeeeDoubles ieee;
  const Parts& all = *parts_;
  if (std::max(all.point_count, all.triangle_count) > std::numeric_limits<std::int32_t>::max()) {
    throw InvalidInput("a surface of more than 2^31 - 1 vertices or triangles cannot be written");
  }
  out << ply_header(comment, static_cast<std::size_t>(all.point_count), static_cast<std::size_t>(all.triangle_count));
  all.points.copy_to(out);
  all.triangles.copy_to(out);
}

}  // namespace flowcert
