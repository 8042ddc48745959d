// The assembler takes the file as it is. A string literal of that size would take the compiler longer, and C++20 has
// no other way to include bytes.
#include <cstddef>

#include "io/viewer_parts.h"

// CMake gives the path, and assembles this file anew when the page has changed.
asm(".section .rodata\n"
    ".global flowcert_viewer_page_start\n"
    ".global flowcert_viewer_page_end\n"
    "flowcert_viewer_page_start:\n"
    ".incbin \"" FLOWCERT_VIEWER_PAGE
    "\"\n"
    "flowcert_viewer_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" const char flowcert_viewer_page_start[];  // NOLINT: the assembler's name
extern "C" const char flowcert_viewer_page_end[];    // NOLINT: the assembler's name

namespace flowcert::io {

std::string_view viewer_template() {
  return {flowcert_viewer_page_start, static_cast<std::size_t>(flowcert_viewer_page_end - flowcert_viewer_page_start)};
}

}  // namespace flowcert::io
