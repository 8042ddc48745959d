// The three ways in which `flowcert verify` reports: tables for people, one JSON object, and a JUnit file for
// CI systems (spec/formats.md, "Cases and answers").
#pragma once

#include <cstddef>
#include <iosfwd>

#include "fuzz/commands/layer.h"
#include "fuzz/judge/verification.h"

namespace flowcert::commands {

// The command that prints a case of the run again; of the whole run without a number.
[[nodiscard]] std::string generate_command(const fuzz::CaseRun& run, std::optional<std::size_t> number);

// most: failing cases shown of those that were kept.
void print_verify_text(const Verification& verification, std::size_t most);
void print_verify_json(const Verification& verification);
void write_verify_junit(std::ostream& out, const Verification& verification);

}  // namespace flowcert::commands
