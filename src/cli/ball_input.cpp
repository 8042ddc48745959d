#include "cli/ball_input.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/progress.h"

namespace flowcert::cli {

std::string BallInput::title() const { return fmt::format("{} ({})", name, file.file.format); }

BallInput read_ball_input(const BallOptions& options) {
  const AtomRadii radii(options.radii);
  BallFile file = [&] {
    const ProgressLine progress = reading_line(options.input, "atoms");
    return read_balls(options.input, options.reading, radii);
  }();
  tell_of_reading(options.input, file.file);
  BallSet balls(file.balls);
  return {display_name(options.input), std::move(file), std::move(balls), options.threads};
}

void add_radii_options(CLI::App& command, BallOptions& options, bool is_needed) {
  CLI::Option* radii =
      command
          .add_option("--radii", options.radii,
                      "The radii of atoms, exact as written: bondi or alvarez, by element; pqr, those of a PQR file; "
                      "column:N of a table; table:FILE, lines with an element and a radius; or a number for all; each "
                      "with ,Fe=2.04 for other elements")
          ->type_name("RADII");
  if (is_needed) radii->required();
  CLI::Option* finite = command.add_flag("--finite", options.reading.finite,
                                         "Take the atoms of a periodic cell for a finite set, without their copies");
  if (!is_needed) finite->needs(radii);
}

}  // namespace flowcert::cli
