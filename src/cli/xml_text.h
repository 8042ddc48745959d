// Text in the XML documents that we write (JUnit).
#pragma once

#include <string>

#include "cli/layer.h"

namespace flowcert::cli {

// Text of an XML 1.0 document, also within double quotes: whatever it holds, the document stays one.
[[nodiscard]] std::string xml_text(const std::string& text);

}  // namespace flowcert::cli
