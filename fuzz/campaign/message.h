// What whoever does batches tells the campaign, and is told: lines of text, through a pipe or between ranks.
//
// Guarantees: a line each, without line breaks inside; what is read is equal to what was written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fuzz/campaign/batch.h"

namespace flowcert::fuzz {

[[nodiscard]] std::string message_of(const Finding& finding);
[[nodiscard]] std::string message_of(const Discovery& discovery);
[[nodiscard]] std::string message_of(std::size_t batch, const BatchResult& result);

// Instead of one: the batch cannot be done on this machine, and why.
[[nodiscard]] std::string failure_message(const std::string& why);
[[nodiscard]] std::optional<std::string> failure_in(const std::string& message);

// Whether it is the last one of a batch, and then whether all of the batch was done.
[[nodiscard]] bool ends_batch(const std::string& message);
[[nodiscard]] bool ends_whole_batch(const std::string& message);

[[nodiscard]] std::string to_text(const BatchOrder& order);
// Throws std::invalid_argument.
[[nodiscard]] BatchOrder order_of(const std::string& text);

}  // namespace flowcert::fuzz
