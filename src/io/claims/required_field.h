// A field that a JSON object has to have.
#pragma once

#include "io/json_fields.h"

namespace flowcert::io {

// Throws InvalidInput "no key 'end'".
[[nodiscard]] const Json& required_field(const Json& object, const char* key);

}  // namespace flowcert::io
