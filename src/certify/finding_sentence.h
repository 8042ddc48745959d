// A plain sentence for each finding, for people who do not know the clauses: what is wrong, and whether it is a bug or
// a convention that can be met otherwise.
//
// Guarantees: every reason has a sentence. It names points by their rows, and says nothing that the finding does not
// know.
#pragma once

#include <string>

#include "certify/layer.h"
#include "certify/truth.h"

namespace flowcert::certify {

[[nodiscard]] std::string finding_sentence(const Finding& finding, const Truth& truth);

}  // namespace flowcert::certify
