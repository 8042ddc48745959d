// The module flowcert_module.wasm: the flow complex as JavaScript holds it. What users see is in the package's index.js,
// and index.d.ts says what is meant; this has what index.js asks.
//
// Guarantees: texts and files are those of the program, to the byte, but for what made them. The content of a file is
// kept as it came, because atoms get their radii from it later.
#include <emscripten/bind.h>
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "flowcert/reproducibility.h"
#include "flowcert/surface.h"
#include "flowcert/write_persistence.h"
#include "flowcert/write_stationary_points.h"
#include "geometry/gmp_memory.h"
#include "io/cycles.h"
#include "io/json_fields.h"
#include "io/naming.h"
#include "io/number_text.h"
#include "io/ordered_text.h"
#include "io/pocket_persistence.h"
#include "io/viewer_page.h"
#include "io/write_cycles.h"
#include "io/write_pockets.h"
#include "morse/part_text.h"
#include "web/module/said.h"

namespace flowcert::web {

using namespace io;

namespace {

// ---- Points ----

std::vector<Point> rows_of(const val& numbers) {
  const auto count = numbers["length"].as<std::size_t>();
  if (count % 3 != 0) throw InvalidInput(fmt::format("{} numbers are no rows of x, y and z", count));
  std::vector<Point> rows(count / 3);
  static_assert(sizeof(Point) == 3 * sizeof(double));
  val(emscripten::typed_memory_view(count, reinterpret_cast<double*>(rows.data()))).call<void>("set", numbers);
  return rows;
}

// A file of NPY's version 1.
std::string npy_of(const PointSet& points) {
  constexpr std::size_t kFront = 10, kUnit = 64;
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, 3), }}", points.row_count());
  header.resize((kFront + header.size()) / kUnit * kUnit + kUnit - kFront - 1, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  append_little_endian(bytes, static_cast<std::uint16_t>(header.size()));
  bytes += header;
  for (PointId row = 0; row < points.row_count(); ++row) {
    for (const double number : points.at_row(row).coordinates()) append_little_endian(bytes, number);
  }
  return bytes;
}

// Points as they came: the numbers of a Float64Array, or the bytes of a file.
struct Source {
  Source(const val& points, const Said& said)
      : name(on_one_line(said.text("name", "points"))), reading(said.reading()) {
    if (points["BYTES_PER_ELEMENT"].as<int>() == 1) {
      bytes = web::bytes_of(points);
      file = read_points_from(bytes, name, reading);
    } else {
      file.rows = rows_of(points);
      file.format = "npy";
    }
  }
  [[nodiscard]] const AtomNames* atoms() const { return file.atoms.empty() ? nullptr : &file.atoms; }

  std::string name, bytes;
  ReadingOptions reading;
  PointFile file;
};

FlowComplex complex_of(const Source& source, const Said& said) {
  PointSet points(source.file.rows, source.file.left_out);
  const std::size_t most = source.reading.unlimited ? kAnyNumberOfCells : usual_most_cells(points.size());
  const auto tell = [said](FlowComplexPart part, std::size_t done, std::size_t total) {
    said.tell(morse::part_text(part), done, total);
  };
  return FlowComplex(std::move(points), {.most_cells = most}, tell);
}

struct Complex {
  Complex(const val& points, const Said& options)
      : said(options), source(points, said), flow(complex_of(source, said)) {
    source.file.rows = {};
  }
  // The file, or one with the same points.
  [[nodiscard]] std::string content() const { return source.bytes.empty() ? npy_of(flow.points()) : source.bytes; }

  Said said;
  Source source;
  FlowComplex flow;
};

val content(const Complex& complex, const Said&) { return array_of_bytes(complex.content()); }

// What is known before anything is computed.
val facts(const Complex& complex, const Said&) {
  const PointFile& file = complex.source.file;
  Json facts{{"name", complex.source.name},
             {"format", file.format},
             {"notes", Json::array()},
             {"leftOut", file.left_out},
             {"hasAtoms", !file.atoms.empty()},
             {"pointCount", complex.flow.points().row_count()},
             {"mergedDuplicates", complex.flow.points().merged_duplicates()}};
  for (const auto& [line, text] : file.notes) facts["notes"].push_back({{"line", line}, {"text", text}});
  return val(json_with_escapes(facts.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

val counts(const Complex& complex, const Said&) {
  Json counts;
  add_counts(counts, complex.flow.points(), complex.flow.stationary());
  return val(counts.dump());
}

// ---- Stationary points ----

val stationary_points(const Complex& complex, const Said&) {
  const StationaryPoints& stationary = complex.flow.stationary();
  std::vector<std::int8_t> indices, kinds;
  std::vector<double> squares;
  std::vector<std::uint32_t> offsets{0}, contacts;
  for (std::size_t place = 0; place < stationary.size(); ++place) {
    const StationaryIndex index = stationary.index(place);
    indices.push_back(static_cast<std::int8_t>(index.is_critical() ? index.face_dimension : -1));
    for (const auto dimension : {index.face_dimension, index.hull_dimension}) {
      kinds.push_back(static_cast<std::int8_t>(dimension));
    }
    squares.push_back(complex.flow.rounded_sphere(place).squared_radius);
    const auto contact = stationary.contact(place);
    contacts.insert(contacts.end(), contact.begin(), contact.end());
    offsets.push_back(static_cast<std::uint32_t>(contacts.size()));
  }
  val columns = val::object();
  columns.set("index", array_of(std::span(indices)));
  columns.set("kind", array_of(std::span(kinds)));
  columns.set("squaredDistance", array_of(std::span(squares)));
  columns.set("contactOffsets", array_of(std::span(offsets)));
  columns.set("contacts", array_of(std::span(contacts)));
  return columns;
}

val centers(const Complex& complex, const Said&) {
  const auto centers = complex.flow.centers();
  return array_of(std::span(reinterpret_cast<const double*>(centers.data()), 3 * centers.size()));
}

// Centre and squared distance, four rationals.
val exact(const Complex& complex, const Said& said) {
  const std::size_t place = said.count("i", 0), count = complex.flow.stationary().size();
  if (place >= count) throw InvalidInput(fmt::format("there is no stationary point {}; there are {}", place, count));
  const ExactSphere sphere = complex.flow.sphere(place);
  Json texts = center_field(sphere.center);
  texts.push_back(to_text(sphere.squared_radius));
  return val(texts.dump());
}

// ---- Pairs ----

// Gives the function `take` arrays in JSON, some pairs at a time.
val persistence(const Complex& complex, const Said& said) {
  const PersistenceDiagram diagram(complex.flow, said.flag("zero"));
  const auto make = [&](std::size_t first, std::size_t last, std::string& text) {
    Json pairs = Json::array();
    for (std::size_t k = first; k < last; ++k) pairs.push_back(pair_field(diagram, diagram.pairs()[k]));
    text = pairs.dump();
  };
  write_in_order(diagram.pairs().size(), kShortRecords, 1, make, [&](const std::string& text, std::size_t) {
    said["take"](text);
    return true;
  });
  return val::undefined();
}

val persistence_text(const Complex& complex, const Said& said) {
  const PersistenceDiagram diagram(complex.flow, said.flag("zero"));
  const auto values = said.flag("plain") ? PersistenceValues::kPlain : PersistenceValues::kSquared;
  return naming(complex.source.name, [&] { return val(pers_text(diagram, values)); });
}

val cycles(const Complex& complex, const Said& said) {
  CycleChoice choice;
  choice.dimension = static_cast<int>(said.count("dimension", 1));
  if (choice.dimension > 2) throw InvalidInput("dimension: not 0, 1 or 2");
  choice.level = cycle_level_of(said.text("level", "25%"), "--level");
  choice.longest = said.count("longest", choice.longest);
  if (said.has("persistence")) choice.longer_than = length_bound_of(said.text("persistence"), "--persistence", 1);
  if (said.has("pair")) choice.pair = pair_name_of(said.text("pair"), "--pair");
  const bool has_witness = said.flag("witness");
  if (has_witness && choice.dimension != 1) throw InvalidInput("--witness is for --dimension 1");
  const std::vector<Cycle> found = flowcert::cycles(complex.flow, choice, complex.said.telling("cycles"));
  return written_text(
      [&](std::ostream& out) { write_cycles(out, {complex.flow, choice.dimension, found, has_witness}); });
}

val pockets(const Complex& complex, const Said& said) {
  std::optional<Probe> probe;
  if (const auto radius = said.length("probe", "--probe")) probe = Probe{*radius};
  const Rational squared = pocket_persistence(complex.flow, said.text("persistence", "auto"), "--persistence").square;
  const Pockets pockets(complex.flow.merge_trees(), squared);
  const bool is_exact = said.word("volumes", {"double", "exact"}) == "exact";
  return written_text(
      [&](std::ostream& out) { write_pockets(out, {complex.flow, pockets, probe, is_exact, complex.source.atoms()}); });
}

// ---- Files ----

val records(const Complex& complex, const Said& said) {
  const std::string manifolds = said.word("manifolds", {"u2", "s2", "u2,s2", "all"});
  RecordsToWrite wanted{.polylines = said.flag("polylines"), .skeletons = said.flag("skeletons")};
  wanted.all = manifolds == "all";
  wanted.u2 = wanted.all || manifolds.starts_with("u2");
  wanted.s2 = wanted.all || manifolds.ends_with("s2");
  if (wanted.polylines && !wanted.u2) throw InvalidInput("--polylines: needs --manifolds u2");
  if (wanted.skeletons && !wanted.s2) throw InvalidInput("--skeletons: needs --manifolds s2");
  return written_bytes(
      [&](std::ostream& out) { write_stationary_points(out, complex.flow, wanted, complex.said.telling("records")); });
}

val surface(const Complex& complex, const Said& said) {
  const std::vector<std::size_t> sets = selected_sets(complex.flow, said.texts("select"));
  const SurfaceMesh mesh =
      naming(complex.source.name, [&] { return surface_mesh(complex.flow, sets, complex.said.telling("surface")); });
  const std::string made_by = made_by_text("flowcert-surface", 1, complex.flow.points());
  const auto write = said.word("format", {"ply", "off"}) == "off" ? write_off : write_ply;
  return written_bytes([&](std::ostream& out) { write(out, mesh, made_by); });
}

val page(const Complex& complex, const Said& said) {
  ViewerOptions content{.name = complex.source.name, .atoms = complex.source.atoms(), .has_cells = said.flag("cells")};
  content.most_of_an_index = said.count("most", content.most_of_an_index);
  content.most_cells = said.count("mostCells", content.most_cells);
  content.most_surfaces = said.count("mostUnstable", content.most_surfaces);
  content.most_pockets = said.count("mostPockets", content.most_pockets);
  std::optional<Pockets> pockets;
  if (said.has("pockets")) {
    const Rational squared = pocket_persistence(complex.flow, said.text("pockets"), "--pockets").square;
    content.pockets = &pockets.emplace(complex.flow.merge_trees(), squared);
  }
  return naming(complex.source.name, [&] {
    return written_bytes(
        [&](std::ostream& out) { write_viewer_page(out, complex.flow, content, complex.said.telling("page")); });
  });
}

std::unique_ptr<Complex> made(const val& points, const val& options) {
  return answer([&] { return std::make_unique<Complex>(points, Said(options)); });
}

template <val (*work)(const Complex&, const Said&)>
val answered(const Complex& complex, const val& options) {
  return answer([&] { return work(complex, Said(options)); });
}

}  // namespace

}  // namespace flowcert::web

EMSCRIPTEN_BINDINGS(flowcert) {
  using namespace flowcert::web;
  flowcert::geometry::let_gmp_fail_as_new_does();
  emscripten::class_<Complex>("Complex")
      .constructor(&made)
      .function("content", &answered<content>)
      .function("facts", &answered<facts>)
      .function("counts", &answered<counts>)
      .function("stationaryPoints", &answered<stationary_points>)
      .function("centers", &answered<centers>)
      .function("exact", &answered<exact>)
      .function("persistence", &answered<persistence>)
      .function("persistenceText", &answered<persistence_text>)
      .function("cycles", &answered<cycles>)
      .function("pockets", &answered<pockets>)
      .function("records", &answered<records>)
      .function("surface", &answered<surface>)
      .function("page", &answered<page>);
}
