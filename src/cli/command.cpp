// See command.h.
#include "cli/command.h"

#include <fmt/format.h>

#include <cstdio>
#include <locale>

#include "flowcert/reproducibility.h"

namespace flowcert::cli {

namespace {

struct Commas : std::numpunct<char> {
 protected:
  [[nodiscard]] char do_thousands_sep() const override { return ','; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

}  // namespace

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string with_commas(unsigned long long value) {
  static const std::locale commas(std::locale::classic(), new Commas);
  return fmt::format(commas, "{:L}", value);
}

Input read_input(const std::string& path) {
  Input input;
  input.file = read_points(path);
  input.points = PointSet(input.file.rows);
  input.sha256 = coordinates_sha256(input.file.rows);
  if (input.file.single_precision) {
    fmt::print(stderr, "note: {}: the coordinates are single precision, and are taken exactly as such\n",
               display_name(path));
  }
  if (input.file.declares_single_precision) {
    fmt::print(stderr,
               "note: {}: declared as float, but decimals: taken as the nearest doubles, not floats\n",
               display_name(path));
  }
  if (const std::size_t merged = input.points.merged_duplicates(); merged > 0) {
    fmt::print(stderr, "warning: {}: {} repeated point{} merged\n", display_name(path), with_commas(merged),
               merged == 1 ? "" : "s");
  }
  return input;
}

}  // namespace flowcert::cli
