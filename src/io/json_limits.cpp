#include "io/json_limits.h"

#include <cstdint>

#include "io/input_bytes.h"
#include "io/line_reader.h"

namespace flowcert::io {

namespace {

// Goes through the text before a tree is made of it, because a tree that is too deep ends its reader.
class LimitChecker : public nlohmann::json_sax<Json> {
 public:
  explicit LimitChecker(std::string_view name) : name_(name) {}

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(std::int64_t /*value*/) override { return true; }
  bool number_unsigned(std::uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(Json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*size*/) override { return require(limits_.open()); }
  bool start_object(std::size_t /*size*/) override { return require(limits_.open()); }
  bool key(std::string& /*key*/) override { return require(limits_.key()); }
  bool end_array() override { return close(); }
  bool end_object() override { return close(); }
  bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& /*error*/) override {
    reject_file(name_, "not JSON, in byte " + std::to_string(position));
  }

 private:
  [[nodiscard]] bool require(const std::string& fault) const {
    if (!fault.empty()) reject_file(name_, fault);
    return true;
  }
  bool close() {
    limits_.close();
    return true;
  }

  std::string_view name_;
  JsonLimits limits_;
};

}  // namespace

std::string JsonLimits::open() {
  if (keys_.size() == kDeepestJson) return "nested deeper than " + std::to_string(kDeepestJson) + " levels";
  keys_.push_back(0);
  return {};
}

std::string JsonLimits::key() {
  if (++keys_.back() <= kMostJsonKeys) return {};
  return "an object of more than " + std::to_string(kMostJsonKeys) + " keys";
}

std::size_t place_of_no_json(std::string_view text) { return text.starts_with(kByteOrderMark) ? 0 : text.find('\0'); }

Json parse_foreign_json(std::string_view text, std::string_view name) {
  if (const std::size_t at = place_of_no_json(text); at != std::string_view::npos) {
    reject_file(name, "not JSON, in byte " + std::to_string(at + 1));
  }
  LimitChecker checker(name);
  Json::sax_parse(text, &checker);
  return Json::parse(text);
}

}  // namespace flowcert::io
