// What commands on atoms with radii are asked for: a file, and the radii.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/layer.h"
#include "flowcert/ball_set.h"
#include "flowcert/read_balls.h"

namespace flowcert::cli {

struct BallOptions : InputOptions {
  std::string radii;
  std::string probe;
};

struct BallInput {
  std::string name;  // for messages
  BallFile file;
  BallSet balls;
  unsigned threads = 1;

  // "cage.xyz (chemical XYZ)"
  [[nodiscard]] std::string title() const;
  // The names of a molecule's atoms; null where it is none.
  [[nodiscard]] const AtomNames* atoms() const { return file.file.atoms.empty() ? nullptr : &file.file.atoms; }
};

// Reads the file, and says on standard error what a user should know of it.
[[nodiscard]] BallInput read_ball_input(const BallOptions& options);

// The options --radii and --finite. `is_needed`: the command has no meaning without radii.
void add_radii_options(CLI::App& command, BallOptions& options, bool is_needed);

}  // namespace flowcert::cli
