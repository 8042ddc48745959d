// The options that say which cases are asked: `generate` prints these cases, and `verify` expects answers to them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/programs/asked_cases.h"
#include "fuzz/commands/layer.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::commands {

struct RunOptions {
  int level = 1;
  std::uint64_t seed = 1;
  std::optional<std::size_t> cases;
  std::vector<std::string> families;
  std::optional<std::size_t> most_points;
  bool asks_vectors = false;
  std::string vectors;    // a folder; empty: the usual one
  bool is_given = false;  // one of these options
};

// Adds --level, --seed, --cases, --family, --vectors and --most-points. They are there after the command line is
// parsed.
void add_run_options(CLI::App& command, RunOptions& options);

// Throws InvalidInput if there are no such vectors.
[[nodiscard]] std::unique_ptr<AskedCases> cases_of(const RunOptions& options);

}  // namespace flowcert::commands
