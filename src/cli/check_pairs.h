// `flowcert check` of a persistence diagram, of cycles and of pores: which claimed pairs, cycles or diameters are
// wrong, and which are missing (FC-FILE-28, FC-CLAIM-11; FC-FILE-53, FC-CLAIM-25; FC-FILE-58, FC-CLAIM-26), for people
// and for CI systems (src/cli/manual/check.md).
#pragma once

#include "certify/list_report.h"
#include "cli/check_report.h"
#include "cli/layer.h"

namespace flowcert::cli {

// At most `most` differences are shown; the table counts all.
void print_check_text(const CheckedFiles& files, const PairReport& report, std::size_t most);
void write_check_junit(std::ostream& out, const CheckedFiles& files, const PairReport& report);

}  // namespace flowcert::cli
