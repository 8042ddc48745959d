// One conformance vector: the runs that it takes, and the judgement of what they leave.
#pragma once

#include <filesystem>
#include <functional>

#include "fuzz/judge/conformance_run.h"

namespace flowcert::judge {

// In a new folder in `scratch`, gone afterwards. If is_cancelled, what is returned means nothing.
[[nodiscard]] CaseOutcome run_case(const VectorCase& one, const ConformanceOptions& options,
                                   const std::filesystem::path& scratch,
                                   const std::function<bool()>& is_cancelled);

}  // namespace flowcert::judge
