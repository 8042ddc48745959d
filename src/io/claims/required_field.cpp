#include "io/claims/required_field.h"

#include <fmt/format.h>

namespace flowcert::io {

const Json& required_field(const Json& object, const char* key) {
  if (!object.is_object()) throw InvalidInput(fmt::format("no object that could have '{}'", key));
  const auto value = object.find(key);
  if (value == object.end()) throw InvalidInput(fmt::format("no key '{}'", key));
  return *value;
}

}  // namespace flowcert::io
