// The data of a page, put into the page that src/viewer/ makes.
#include "io/viewer_page.h"

#include <algorithm>
#include <bit>
#include <boost/algorithm/string/replace.hpp>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "flowcert/surface.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "io/viewer_parts.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::uint32_t kNone = ViewerSelection::kNone;
using Numbers = std::vector<std::uint32_t>;
using Floats = std::vector<float>;

// What all parts of the data are made of.
struct ViewerContent {
  const FlowComplex& complex;
  const ViewerFrame& frame;
  const ViewerSelection& selection;

  [[nodiscard]] std::uint32_t sample(PointId name) const {
    return static_cast<std::uint32_t>(complex.points().ordinal_of_row(name));
  }
};

// ---- Points ----

Json sample_coordinates(std::span<const Point> points) {
  std::vector<double> coordinates;
  for (const Point& point : points) coordinates.insert(coordinates.end(), {point.x, point.y, point.z});
  return viewer_blob(coordinates);
}

Numbers sample_rows(const PointSet& points) {
  Numbers rows;
  for (std::size_t i = 0; i < points.size(); ++i) rows.push_back(points.name(i));
  return rows;
}

// Elements are listed once, in the order in which they come.
Json atoms_field(const AtomNames* atoms, const Numbers& rows) {
  if (atoms == nullptr) return nullptr;
  std::unordered_map<std::string, std::uint32_t> place_of;
  Json elements = Json::array(), names = Json::array();
  Numbers element;
  for (const PointId row : rows) {
    const auto [found, is_new] =
        place_of.try_emplace(std::string((*atoms)[row].element), static_cast<std::uint32_t>(place_of.size()));
    if (is_new) elements.push_back(found->first);
    element.push_back(found->second);
    names.push_back(atoms->text(row));
  }
  return {{"elements", std::move(elements)}, {"element", viewer_blob(element)}, {"names", std::move(names)}};
}

// The page computes the sphere of such a point itself: a midpoint, or the centre of an acute triangle's circle, which
// doubles give well.
bool is_plain(const StationaryPoints& stationary, std::size_t record) {
  const StationaryIndex index = stationary.index(record);
  return index.is_critical() && index.hull_dimension <= 2 &&
         stationary.contact(record).size() == static_cast<std::size_t>(index.hull_dimension) + 1;
}

Json records_field(const ViewerContent& content) {
  const StationaryPoints& stationary = content.complex.stationary();
  Numbers numbers, offsets = {0}, contacts, edges;
  std::vector<std::uint8_t> faces, hulls;
  Floats positions;
  std::vector<double> squared;
  for (const std::size_t record : content.selection.records) {
    const StationaryIndex index = stationary.index(record);
    numbers.push_back(static_cast<std::uint32_t>(record));
    faces.push_back(static_cast<std::uint8_t>(index.face_dimension));
    hulls.push_back(static_cast<std::uint8_t>(index.hull_dimension));
    if (!is_plain(stationary, record)) {
      const RoundedSphere sphere = content.complex.rounded_sphere(record);
      content.frame.append(positions, sphere.center);
      squared.push_back(sphere.squared_radius);
    }
    for (const PointId name : stationary.contact(record)) contacts.push_back(content.sample(name));
    offsets.push_back(static_cast<std::uint32_t>(contacts.size()));
    if (index.face_dimension == 1) {
      for (const PointId name : content.complex.samples_of(record)) edges.push_back(content.sample(name));
    } else {
      edges.insert(edges.end(), 2, kNone);
    }
  }
  return {{"numbers", viewer_blob(numbers)},   {"face", viewer_blob(faces)},
          {"hull", viewer_blob(hulls)},        {"positions", viewer_blob(positions)},
          {"squared", viewer_blob(squared)},   {"contact_offsets", viewer_blob(offsets)},
          {"contacts", viewer_blob(contacts)}, {"edges", viewer_blob(edges)}};
}

Json pairs_field(const ViewerContent& content) {
  std::vector<std::uint8_t> dimensions;
  Numbers births, deaths, birth_samples;
  for (const PersistencePair* pair : content.selection.pairs) {
    dimensions.push_back(static_cast<std::uint8_t>(pair->dimension));
    births.push_back(content.selection.place[pair->birth]);
    deaths.push_back(pair->death ? content.selection.place[*pair->death] : kNone);
    // The critical points of index 0 are the first records, in the order of the samples.
    birth_samples.push_back(pair->dimension == 0 ? static_cast<std::uint32_t>(pair->birth) : kNone);
  }
  return {{"dimension", viewer_blob(dimensions)},
          {"birth", viewer_blob(births)},
          {"death", viewer_blob(deaths)},
          {"birth_sample", viewer_blob(birth_samples)}};
}

// ---- Manifolds ----

Json s2_field(const ViewerContent& content, Floats& vertices, const Progress& progress) {
  const StableManifolds& s2 = content.complex.stable();
  const SurfaceMesh mesh = surface_mesh(content.complex, content.selection.sets, progress);
  Numbers records, offsets = {0}, triangles;
  std::vector<std::uint8_t> have_interval;
  for (const Point& vertex : mesh.vertices) content.frame.append(vertices, vertex);
  std::size_t done = 0;
  for (const std::size_t set : content.selection.sets) {
    records.push_back(content.selection.place[s2.record(set)]);
    have_interval.push_back(s2.has_interval(set) ? 1 : 0);
    for (; done < mesh.triangles.size() && mesh.set_of_triangle[done] == set; ++done) {
      triangles.insert(triangles.end(), mesh.triangles[done].begin(), mesh.triangles[done].end());
    }
    offsets.push_back(static_cast<std::uint32_t>(done));
  }
  return {{"record", viewer_blob(records)},
          {"triangle_offsets", viewer_blob(offsets)},
          {"vertices", viewer_blob(vertices)},
          {"triangles", viewer_blob(triangles)},
          {"has_interval", viewer_blob(have_interval)}};
}

// Lines as a forest. Two lines share what they have in common at their ends. It is found from the ends, so that lines
// that only look alike for a while are not led astray.
class LineForest {
 public:
  // Returns where the line starts.
  std::uint32_t append(const std::vector<std::array<double, 3>>& line) {
    std::uint32_t next = kNone;
    for (std::size_t i = length_in_view(line); i-- > 0;) {
      const Position at = i == 0 ? line[0] : end_in_reach(line[i - 1], line[i]);
      const Key key = {std::bit_cast<std::uint64_t>(at[0]), std::bit_cast<std::uint64_t>(at[1]),
                       std::bit_cast<std::uint64_t>(at[2]), next};
      const auto [found, is_new] = vertex_of_.try_emplace(key, static_cast<std::uint32_t>(next_.size()));
      if (is_new) {
        positions_.push_back(at);
        next_.push_back(next);
      }
      next = found->second;
    }
    return next;
  }

  [[nodiscard]] const Numbers& next() const { return next_; }

  // The positions are multiples of this. A large forest has larger steps, which are still less than a pixel.
  [[nodiscard]] double step() const {
    constexpr std::size_t kLarge = 200000;
    constexpr double kSmallStep = 0x1p-20, kLargeStep = 0x1p-13;
    return next_.size() > kLarge ? kLargeStep : kSmallStep;
  }

  // From the next vertex of each, or the origin, as numbers of steps. Even numbers stand for steps ahead, odd ones for
  // steps back.
  [[nodiscard]] Numbers steps() const {
    std::vector<std::array<long long, 3>> at(positions_.size());
    Numbers steps;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at[i][axis] = std::llround(positions_[i][axis] / step());
        const long long ahead = at[i][axis] - (next_[i] == kNone ? 0 : at[next_[i]][axis]);
        steps.push_back(static_cast<std::uint32_t>(ahead < 0 ? -2 * ahead - 1 : 2 * ahead));
      }
    }
    return steps;
  }

 private:
  using Key = std::array<std::uint64_t, 4>;
  using Position = std::array<double, 3>;

  // A line that has left the hull of the samples never comes back, so what follows the box is not seen.
  [[nodiscard]] static std::size_t length_in_view(const std::vector<Position>& line) {
    const auto is_outside = [](const Position& at) {
      return std::ranges::any_of(at, [](double x) { return std::abs(x) > ViewerFrame::kClip; });
    };
    const auto first = std::ranges::find_if(line, is_outside);
    return first == line.end() ? line.size() : static_cast<std::size_t>(first - line.begin()) + 1;
  }

  // Where a segment ends, or a point on it, if it goes on far out of the box.
  [[nodiscard]] static Position end_in_reach(const Position& start, Position end) {
    constexpr double kReach = 64;
    const double farthest = std::max({std::abs(end[0]), std::abs(end[1]), std::abs(end[2])});
    if (farthest <= kReach) return end;
    for (std::size_t axis = 0; axis < 3; ++axis)
      end[axis] = start[axis] + (end[axis] - start[axis]) * kReach / farthest;
    return end;
  }

  std::vector<Position> positions_;
  Numbers next_;
  std::unordered_map<Key, std::uint32_t, boost::hash<Key>> vertex_of_;
};

// In the frame. An orbit to infinity gets a last point out of view.
std::vector<std::array<double, 3>> visible_orbit(const ViewerContent& content, std::size_t i, std::size_t side) {
  constexpr double kFar = 32;
  const UnstableManifolds& u2 = content.complex.unstable();
  std::vector<std::array<double, 3>> line;
  for (const RoundedSphere& sphere : u2.rounded_orbit(i, side)) line.push_back(content.frame.placed(sphere.center));
  if (const auto way = u2.direction_to_infinity(i, side)) {
    const auto [x, y, z] = line.back();
    line.push_back({x + kFar * way->x, y + kFar * way->y, z + kFar * way->z});
  }
  return line;
}

Json u2_field(const ViewerContent& content, const Progress& progress) {
  const UnstableManifolds& u2 = content.complex.unstable();
  Numbers records, starts, limits;
  LineForest forest;
  std::size_t done = 0;
  for (const std::size_t i : content.selection.sets) {
    records.push_back(content.selection.place[u2.saddle(i)]);
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      const auto limit = u2.limit(i, side);
      starts.push_back(forest.append(visible_orbit(content, i, side)));
      limits.push_back(limit ? content.selection.place[*limit] : kNone);
    }
    if (progress) progress(++done, content.selection.sets.size());
  }
  return {{"record", viewer_blob(records)},       {"starts", viewer_blob(starts)},
          {"limits", viewer_blob(limits)},        {"step", forest.step()},
          {"steps", viewer_blob(forest.steps())}, {"next", viewer_blob(forest.next())}};
}

// ---- A claim ----

// The page knows stationary points by their places among its records.
Json claim_field(const ViewerSelection& selection, Json claim) {
  if (claim.is_null()) return claim;
  for (Json& finding : claim["findings"]) {
    Json& record = finding["record"];
    if (record.is_null()) continue;
    const std::uint32_t place = selection.place[record.get<std::size_t>()];
    record = place == kNone ? Json(nullptr) : Json(place);
  }
  return claim;
}

// ---- The page ----

Json data_of(const FlowComplex& complex, const ViewerOptions& options, const ViewerSelection& selection,
             const Progress& progress) {
  const ViewerFrame frame(complex.points().points());
  const ViewerContent content = {complex, frame, selection};
  Json data = header_fields("flowcert-view", 1, complex.points());
  add_counts(data, complex.points(), complex.stationary());
  data["name"] = options.name;
  data["origin"] = frame.origin();
  data["unit"] = frame.unit();
  data["thinned"] = nullptr;
  if (selection.records.size() < selection.all_records) {
    data["thinned"] = {{"of", selection.all_records}, {"kept", selection.records.size()}};
  }
  const Numbers rows = sample_rows(complex.points());
  data["samples"] = sample_coordinates(complex.points().points());
  data["sample_rows"] = viewer_blob(rows);
  data["atoms"] = atoms_field(options.atoms, rows);
  data["records"] = records_field(content);
  data["pairs"] = pairs_field(content);
  Floats s2_vertices;
  data["s2"] = s2_field(content, s2_vertices, progress);
  data["u2"] = u2_field(content, progress);
  data["cycles"] = viewer_cycles_field(complex, frame, selection, s2_vertices);
  if (options.has_cells) data["cells"] = viewer_cells_field(complex, frame, selection);
  if (options.pockets) data["pockets"] = viewer_pockets_field(complex, frame, *options.pockets, options.most_pockets);
  data["claim"] = claim_field(selection, options.claim);
  return data;
}

// The frame is that of the box around the balls.
Json data_of_balls(const std::string& name, std::span<const Point> centres, const PoresToWrite& what) {
  Numbers rows;
  std::vector<double> radii;
  std::vector<Point> corners;
  const auto within_doubles = [](double sum) {
    return std::clamp(sum, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  };
  for (const auto& [x, y, z] : centres) {
    rows.push_back(static_cast<std::uint32_t>(rows.size()));
    const double r = radii.emplace_back(nearest_or_infinity(what.pores.balls()[rows.back()].radius));
    corners.push_back({within_doubles(x - r), within_doubles(y - r), within_doubles(z - r)});
    corners.push_back({within_doubles(x + r), within_doubles(y + r), within_doubles(z + r)});
  }
  const ViewerFrame frame(corners);
  Json data = header_fields("flowcert-view", 1);
  data["points"] = centres.size();
  data["name"] = name;
  data["origin"] = frame.origin();
  data["unit"] = frame.unit();
  data["samples"] = sample_coordinates(centres);
  data["sample_rows"] = viewer_blob(rows);
  data["atoms"] = atoms_field(what.atoms, rows);
  data["radii"] = viewer_blob(radii);
  std::ostringstream pores;
  write_pores(pores, what);
  data["pores"] = Json::parse(pores.str());
  data["pores"].erase("cavities");
  return data;
}

// The data as the text of a script element: nothing in it can end the element, or begin a comment.
void write_page_with(std::ostream& out, const Json& data) {
  constexpr std::string_view kNull = "null</script>";
  const std::string_view page = viewer_template();
  const std::size_t at = page.find(kPlaceOfData);
  if (at == std::string_view::npos) throw std::logic_error("the viewer's page has no place for data");
  const std::size_t data_at = at + kPlaceOfData.size() - kNull.size();
  out << page.substr(0, data_at)
      << boost::replace_all_copy(data.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c")
      << page.substr(data_at + std::string_view("null").size());
}

}  // namespace

ViewerCounts write_viewer_page(std::ostream& out, const FlowComplex& complex, const ViewerOptions& options,
                               const Progress& progress) {
  const geometry::IeeeDoubles ieee;
  complex.make(FlowComplexPart::kPersistence);
  ViewerSelection selection = viewer_selection(complex, options.most_of_an_index);
  if (options.has_cells) choose_cells(complex, options.most_cells, options.most_surfaces, selection);
  write_page_with(out, data_of(complex, options, selection, progress));
  const std::size_t all_pockets = options.pockets ? options.pockets->size() : 0;
  return {.records = {selection.records.size(), selection.all_records},
          .cells = {selection.cells.size(), selection.all_cells},
          .surfaces = {selection.surfaces.size(), selection.all_surfaces},
          .pockets = {std::min(options.most_pockets, all_pockets), all_pockets}};
}

void write_viewer_page(std::ostream& out, const std::string& name, std::span<const Point> centres,
                       const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  write_page_with(out, data_of_balls(name, centres, what));
}

}  // namespace flowcert
