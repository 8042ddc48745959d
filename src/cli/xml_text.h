// Text in documents that are XML: JUnit files and pictures.
//
// Guarantees: whatever the text holds, the document stays valid.
#pragma once

#include <string>

#include "cli/layer.h"

namespace flowcert::cli {

// The text, escaped for an XML 1.0 document, also within double quotes.
[[nodiscard]] std::string xml_text(const std::string& text);

}  // namespace flowcert::cli
