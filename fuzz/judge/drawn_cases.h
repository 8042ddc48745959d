// The cases of a run that is drawn (fuzz/inputs/case_stream.h), for the commands that ask cases.
#pragma once

#include <memory>
#include <string>

#include "certify/programs/asked_cases.h"
#include "fuzz/inputs/case_stream.h"
#include "fuzz/judge/layer.h"

namespace flowcert::judge {

[[nodiscard]] std::unique_ptr<AskedCases> drawn_cases(const fuzz::CaseRun& run);
// The cases of the run to which the id belongs; null if it belongs to none.
[[nodiscard]] std::unique_ptr<AskedCases> drawn_cases_of(const std::string& id);

}  // namespace flowcert::judge
