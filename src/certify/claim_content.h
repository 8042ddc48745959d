// The claim in a file's plain content (io/input_bytes.h), for readers that have looked at the content already.
#pragma once

#include <string>
#include <string_view>

#include "certify/layer.h"
#include "flowcert/claim.h"

namespace flowcert::certify {

// By the first format that recognises it. Throws as read_claim() does.
[[nodiscard]] Claim claim_in(std::string_view content, const std::string& name, bool unlimited);

}  // namespace flowcert::certify
