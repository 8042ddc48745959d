// The module check_module.wasm: what `flowcert check` does, and its --json. index.js loads it when it is asked for.
#include <emscripten/bind.h>
#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

#include "certify/any_claim.h"
#include "certify/check_json.h"
#include "flowcert/flow_complex.h"
#include "flowcert/read_balls.h"
#include "geometry/gmp_memory.h"
#include "io/number_text.h"
#include "web/module/said.h"

namespace flowcert::web {

using namespace certify;

namespace {

CheckOptions options_of(const Said& said, const Said& input) {
  CheckOptions options;
  options.tolerance = said.number("tolerance", kDefaultTolerance);
  if (!(0 <= options.tolerance && options.tolerance <= kLargestTolerance)) {
    throw InvalidInput(fmt::format("tolerance must be from 0 to {}", kLargestTolerance));
  }
  options.highest_level = static_cast<int>(said.count("highestLevel", kLevels));
  if (options.highest_level < 1 || options.highest_level > kLevels) {
    throw InvalidInput("highestLevel must be from 1 to 5");
  }
  if (said.has("indices")) options.indices = {};
  for (const std::string& index : said.texts("indices")) {
    options.indices.at(static_cast<std::size_t>(claimed_index(index, {"--indices", 1}))) = true;
  }
  options.progress = [input](int level, std::size_t done, std::size_t total) {
    input.tell("checking level " + std::to_string(level), done, total);
  };
  return options;
}

FlowComplex complex_of(const PointSet& points, const ReadingOptions& reading) {
  return FlowComplex(points, {.most_cells = reading.unlimited ? kAnyNumberOfCells : usual_most_cells(points.size())});
}

Json judged_pores(CheckedFiles files, const PoreClaim& claim, std::string_view bytes, ReadingOptions reading,
                  const Said& said) {
  refuse_levels(files.check, "of pores");
  require_radii(true, said.has("radii"));
  if (!said.has("tolerance")) files.check.tolerance = kPoreTolerance;
  reading.finite = said.flag("finite");
  const BallFile read = read_balls_from(bytes, files.points, reading, AtomRadii(said.text("radii")));
  const BallSet balls(read.balls);
  files.claim_format = "pores";
  const PairReport report = report_of_pores(claim, Pores(balls, claim.depth), files.check.tolerance, files.claim);
  return check_json(files, report, PointSet(read.file.rows));
}

Json judged(CheckedFiles& files, const Claim& claim, const PointSet& points, const FlowComplex& complex) {
  require_rows(claim, points, files.claim);
  files.claim_format = claim.format;
  return check_json(files, check(complex, claim, files.check), points);
}

Json judged(CheckedFiles& files, const CycleClaim& claim, const PointSet& points, const FlowComplex& complex) {
  refuse_levels(files.check, "of cycles");
  require_rows(claim, points, files.claim);
  files.claim_format = "cycles";
  return check_json(files, report_of_cycles(claim, complex, files.check.tolerance), points);
}

Json judged(CheckedFiles& files, const std::vector<ClaimedPair>& claim, const PointSet& points,
            const FlowComplex& complex) {
  refuse_levels(files.check, "a persistence diagram");
  files.claim_format = "persistence";
  return check_json(files, report_of_pairs(claim, listed_pairs(complex), files.check.tolerance), points);
}

// content: of the file of points. input, options: those of FlowComplex, and of check().
std::string check_text(const val& content, const val& input, const val& claim_content, const val& options) {
  const Said said(options), read(input);
  const std::string bytes = bytes_of(content);
  const ReadingOptions reading = read.reading();
  CheckedFiles files;
  files.points = read.text("name", "points");
  files.claim = said.text("name", "claim");
  files.check = options_of(said, read);
  const std::string format = said.word("format", {"pers", "pores"});
  const AnyClaim claim = any_claim_in(bytes_of(claim_content), files.claim, format, reading.unlimited);
  if (const auto* pores = std::get_if<PoreClaim>(&claim)) {
    return report_text(judged_pores(files, *pores, bytes, reading, said));
  }
  require_radii(false, said.has("radii"));
  const PointFile file = read_points_from(bytes, files.points, reading);
  if (!file.atoms.empty()) files.atoms = &file.atoms;
  const PointSet points(file.rows, file.left_out);
  const FlowComplex complex = complex_of(points, reading);
  if (const auto* one = std::get_if<Claim>(&claim)) return report_text(judged(files, *one, points, complex));
  if (const auto* one = std::get_if<CycleClaim>(&claim)) return report_text(judged(files, *one, points, complex));
  return report_text(judged(files, std::get<std::vector<ClaimedPair>>(claim), points, complex));
}

}  // namespace

}  // namespace flowcert::web

EMSCRIPTEN_BINDINGS(flowcert_check) {
  using flowcert::web::val;
  flowcert::geometry::let_gmp_fail_as_new_does();
  emscripten::function(
      "check", +[](const val& content, const val& input, const val& claim, const val& options) {
        return flowcert::web::answer([&] { return flowcert::web::check_text(content, input, claim, options); });
      });
}
