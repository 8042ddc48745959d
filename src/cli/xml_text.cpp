// See xml_text.h.
#include "cli/xml_text.h"

namespace flowcert::cli {

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        // Control characters do not exist there; nor do bytes that are no UTF-8, which file names may have.
        escaped += (static_cast<unsigned char>(c) < 0x20 && c != '\n') || (c & 0x80) != 0 ? '?' : c;
    }
  }
  return escaped;
}

}  // namespace flowcert::cli
