// `conformance --report`: a page with the tables, flags and findings of a run (spec/formats/conformance.md).
//
// Guarantees: the page is one file that needs nothing else. It says what --json says, in words. No text of a program
// or of a file can become markup.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "cli/layer.h"
#include "io/json_fields.h"

namespace flowcert::cli {

struct ConformancePageContext {
  // Where --keep has left its folders, as seen from the page. Empty: there are none.
  std::string kept_folder;
  // Whether that has left this, "ID" or "ID/page.html".
  std::function<bool(const std::string& name)> is_kept;
};

// report: as --json prints it.
void write_conformance_page(std::ostream& out, const Json& report, const ConformancePageContext& context);

}  // namespace flowcert::cli
