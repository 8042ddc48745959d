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
        // XML 1.0 has no control characters. File names may also hold bytes that are not UTF-8.
        escaped += (static_cast<unsigned char>(c) < 0x20 && c != '\n') || (c & 0x80) != 0 ? '?' : c;
    }
  }
  return escaped;
}

}  // namespace flowcert::cli
