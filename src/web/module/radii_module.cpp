// The module radii_module.wasm: atoms with radii, without a flow complex. index.js loads it when it is asked for.
//
// Guarantees: texts and pages are those of the program, to the byte, but for what made them.
#include <emscripten/bind.h>

#include <sstream>
#include <string>

#include "flowcert/ball_cavities.h"
#include "flowcert/pores.h"
#include "flowcert/read_balls.h"
#include "geometry/gmp_memory.h"
#include "io/number_text.h"
#include "io/viewer_page.h"
#include "io/write_pores.h"
#include "web/module/said.h"

namespace flowcert::web {

using namespace io;

namespace {

// content: of the file of points. input, options: those of FlowComplex, and of the method.
struct Atoms {
  Atoms(const val& content, const val& input, const val& options)
      : said(options), name(on_one_line(Said(input).text("name", "points"))), radii(on_one_line(said.text("radii"))) {
    ReadingOptions reading = Said(input).reading();
    reading.finite = said.flag("finite");
    read = read_balls_from(bytes_of(content), name, reading, AtomRadii(said.text("radii")));
  }
  [[nodiscard]] const AtomNames* names() const { return read.file.atoms.empty() ? nullptr : &read.file.atoms; }

  Said said;
  std::string name, radii;
  BallFile read;
};

val cavities(const Atoms& atoms) {
  const Rational probe = length_of_option(atoms.said.text("probe"), "--probe");
  const BallSet balls(atoms.read.balls);
  const std::vector<BallCavity> cavities = ball_cavities(balls, probe);
  return written_text(
      [&](std::ostream& out) { write_cavities(out, {balls, cavities, probe, atoms.names(), atoms.radii}); });
}

// write: is given the pores.
val with_pores(const Atoms& atoms, const auto& write) {
  const Rational depth = length_of_option(atoms.said.text("depth", "0.1"), "--depth");
  const auto probe = atoms.said.length("probe", "--probe");
  const BallSet balls(atoms.read.balls);
  const Pores pores(balls, depth);
  return write(PoresToWrite{pores, depth, probe, atoms.names(), atoms.radii});
}

val pores(const Atoms& atoms) {
  return with_pores(
      atoms, [](const PoresToWrite& what) { return written_text([&](std::ostream& out) { write_pores(out, what); }); });
}

val page(const Atoms& atoms) {
  return with_pores(atoms, [&](const PoresToWrite& what) {
    return written_bytes([&](std::ostream& out) { write_viewer_page(out, atoms.name, atoms.read.file.rows, what); });
  });
}

template <val (*work)(const Atoms&)>
val answered(const val& content, const val& input, const val& options) {
  return answer([&] { return work(Atoms(content, input, options)); });
}

}  // namespace

}  // namespace flowcert::web

EMSCRIPTEN_BINDINGS(flowcert_radii) {
  using namespace flowcert::web;
  flowcert::geometry::let_gmp_fail_as_new_does();
  emscripten::function("pockets", &answered<cavities>);
  emscripten::function("pores", &answered<pores>);
  emscripten::function("page", &answered<page>);
}
