#include "io/claims/required_field.h"

#include <fmt/format.h>

#include "io/rational_text.h"

namespace flowcert::io {

const Json& required_field(const Json& object, const char* key) {
  if (!object.is_object()) throw InvalidInput(fmt::format("no object that could have '{}'", key));
  const auto value = object.find(key);
  if (value == object.end()) throw InvalidInput(fmt::format("no key '{}'", key));
  return *value;
}

const Json::string_t& required_string(const Json& value, const char* what) {
  if (!value.is_string()) throw InvalidInput(fmt::format("'{}' is no string", what));
  return value.get_ref<const Json::string_t&>();
}

const Json& required_array(const Json& value, const char* what) {
  if (!value.is_array()) throw InvalidInput(fmt::format("'{}' is no array", what));
  return value;
}

Rational required_rational(const Json& value, const char* what) {
  return exact_rational(required_string(value, what));
}

}  // namespace flowcert::io
