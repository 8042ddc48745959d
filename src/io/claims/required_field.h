// What a claim in JSON has to have, and of which type. Each function throws InvalidInput, "no key 'end'" or "'end' is no
// string", where it is not so.
#pragma once

#include "io/json_fields.h"

namespace flowcert::io {

[[nodiscard]] const Json& required_field(const Json& object, const char* key);

// what: the key that the value belongs to, for messages.
[[nodiscard]] const Json::string_t& required_string(const Json& value, const char* what);
[[nodiscard]] const Json& required_array(const Json& value, const char* what);
// A string that exact_rational() takes.
[[nodiscard]] Rational required_rational(const Json& value, const char* what);

}  // namespace flowcert::io
