// `flowcert check`. Its caller hands it the other implementation for --oracle, because src/ knows none.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "cli/command.h"
#include "flowcert/check.h"
#include "flowcert/pair_differences.h"

namespace flowcert::cli {

// An implementation that shares nothing with this one, for `--oracle`.
struct OtherTruth {
  std::size_t most_points = 0;
  // Throws InvalidInput for more points.
  std::function<std::unique_ptr<Truth>(const std::vector<Point>& rows)> of;
  // Persistence pairs by it. Throws InvalidInput for more points, and takes fewer of them.
  std::function<std::vector<ListedPair>(const std::vector<Point>& rows)> pairs_of;
};

void add_check_command(CLI::App& app, int& status, const OtherTruth& oracle);

}  // namespace flowcert::cli
