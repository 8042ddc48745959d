// A user's command with places to be filled in, as {in} and {out}.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

[[nodiscard]] bool has_place(std::string_view command, std::string_view place);

// As one word of the shell, whatever it holds.
[[nodiscard]] std::string shell_word(const std::string& text);

// Each place of the first with the second as one word of the shell, whatever it holds. What is filled in is
// not looked at again.
[[nodiscard]] std::string filled_in(std::string_view command,
                                    const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace flowcert::judge
