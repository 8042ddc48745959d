// See message.h. What Campaign::absorb reads has one of the keys "finding", "discovery" and "batch".
#include "fuzz/campaign/message.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace flowcert::fuzz {

using nlohmann::json;

// Messages of exceptions may be anything but UTF-8.
std::string message_of(const Finding& finding) {
  return json{{"finding", json_of(finding)}}.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string message_of(const Discovery& discovery) { return json{{"discovery", json_of(discovery)}}.dump(); }

std::string message_of(std::size_t batch, const BatchResult& result) {
  return json{{"batch", batch}, {"complete", result.is_complete}, {"tally", json_of(result.tally)}}.dump();
}

std::string failure_message(const std::string& why) {
  return json{{"failure", why}}.dump(-1, ' ', true, json::error_handler_t::replace);
}
std::optional<std::string> failure_in(const std::string& message) {
  if (!message.starts_with(R"({"failure":)")) return std::nullopt;
  return json::parse(message).at("failure").get<std::string>();
}

// Keys are written in alphabetical order.
bool ends_batch(const std::string& message) { return message.starts_with(R"({"batch":)"); }
bool ends_whole_batch(const std::string& message) {
  return ends_batch(message) && message.find(R"("complete":true)") != std::string::npos;
}

std::string to_text(const BatchOrder& order) {
  std::string text = std::to_string(order.batch) + ' ' + std::to_string(order.cases) + ' ' +
                     (order.only ? std::to_string(*order.only) : "all");
  for (const std::size_t number : order.left_out) text += ' ' + std::to_string(number);
  return text;
}

BatchOrder order_of(const std::string& text) {
  std::istringstream words(text);
  BatchOrder order;
  std::string only;
  if (!(words >> order.batch >> order.cases >> only)) throw std::invalid_argument("no order for a batch");
  if (only != "all") order.only = std::stoull(only);
  for (std::size_t number = 0; words >> number;) order.left_out.insert(number);
  return order;
}

}  // namespace flowcert::fuzz
