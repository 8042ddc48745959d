#include "web/module/said.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/number_text.h"

namespace flowcert::web {

namespace {

std::string text_of(const val& value) { return val::global("String")(value).as<std::string>(); }

}  // namespace

std::string Said::text(const char* name, std::string otherwise) const {
  return has(name) ? text_of(object_[name]) : otherwise;
}

std::string Said::word(const char* name, std::initializer_list<const char*> words) const {
  std::string said = text(name);
  if (!has(name) || std::ranges::count(words, said) > 0) return said;
  throw InvalidInput(fmt::format("{}: {} is not one of '{}'", name, io::in_quotes(said), fmt::join(words, "', '")));
}

std::vector<std::string> Said::texts(const char* name) const {
  if (!has(name)) return {};
  const val value = object_[name];
  if (!value.isArray()) return {text_of(value)};
  std::vector<std::string> texts;
  for (const val& each : emscripten::vecFromJSArray<val>(value)) texts.push_back(text_of(each));
  return texts;
}

double Said::number(const char* name, double otherwise) const {
  return has(name) ? val::global("Number")(object_[name]).as<double>() : otherwise;
}

std::size_t Said::count(const char* name, std::size_t otherwise) const {
  constexpr double kMost = 0xfffffff;
  const double value = number(name, static_cast<double>(otherwise));
  if (value >= 0 && value <= kMost && value == std::floor(value)) return static_cast<std::size_t>(value);
  throw InvalidInput(std::string(name) + ": no whole number from 0 on: " + text(name));
}

std::optional<Rational> Said::length(const char* name, const char* option) const {
  return has(name) ? std::optional(io::length_of_option(text(name), option)) : std::nullopt;
}

ReadingOptions Said::reading() const {
  ReadingOptions options{.format = text("format"),
                         .columns = text("columns"),
                         .chains = texts("chains"),
                         .atoms = texts("atoms"),
                         .models = text("models"),
                         .frame = count("frame", 0),
                         .skip_invalid = flag("skipInvalid"),
                         .unlimited = flag("unlimited"),
                         .finite = flag("finite")};
  if (has("z")) options.z = number("z", 0);
  return options;
}

void Said::tell(const std::string& part, std::size_t done, std::size_t total) const {
  if (has("progress")) object_["progress"](part, static_cast<double>(done), static_cast<double>(total));
}

Progress Said::telling(const char* part) const {
  return [said = *this, part](std::size_t done, std::size_t total) { said.tell(part, done, total); };
}

std::string bytes_of(const val& array) {
  std::string bytes(array["length"].as<std::size_t>(), '\0');
  val(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<unsigned char*>(bytes.data())))
      .call<void>("set", array);
  return bytes;
}

val array_of_bytes(const std::string& bytes) {
  return array_of(std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace flowcert::web
