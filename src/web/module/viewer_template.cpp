// The viewer's page is a file beside the modules, which index.js puts around what a module says.
#include "io/viewer_parts.h"

std::string_view flowcert::io::viewer_template() { return kPlaceOfData; }
