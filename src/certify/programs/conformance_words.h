// The words in which a conformance run speaks of outcomes and findings: the same in every kind of report.
#pragma once

#include <string>

#include "certify/programs/conformance_run.h"

namespace flowcert::certify {

// "level 3: missing [FC-CLAIM-03]: claimed nothing; truth: ..."
[[nodiscard]] std::string finding_words(const Finding& finding);

// "orbit from 1/2,0,0: claimed segment 2: type E-F-V; truth: E-F-E"
[[nodiscard]] std::string orbit_finding_words(const OrbitFinding& finding);

// "persistence: claimed dimension 1, birth 1/2, death 3/4; truth: no such pair"
[[nodiscard]] std::string persistence_finding_words(const PairDifference& difference);

// What a program under test has written, for a line of a report: without control characters, and not endless.
[[nodiscard]] std::string one_line(const std::string& text);

}  // namespace flowcert::certify
