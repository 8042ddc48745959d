// Another implementation's command as a property: what it claims of an input is right.
//
// Guarantees: those of command_run.h and flowcert/check.h: however the command ends, there is a verdict, and
// what the claim is free to say is permitted. The kind of a disagreement is how the run ended ("signal",
// "time-limit", "refusal", "unreadable", "not-started"), or the reason of the finding that says most
// ("missed-by-cluster", "wrong-pair"). The claim is judged in the same way whether the command is started for each
// input or asked case after case (case_dialogue.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "certify/programs/limited_program.h"
#include "flowcert/check.h"
#include "fuzz/judge/layer.h"
#include "fuzz/properties/property.h"

namespace flowcert::judge {

struct PeerOptions {
  std::string command;  // with {in}, and {out}, or else standard output; with is_dialogue without places
  std::string out_name = "claim";
  ProgramLimits limits;
  CheckOptions check;
  bool is_dialogue = false;                                   // the command is asked case after case, in one process
  bool judges_pairs = false;                                  // the command writes persistence pairs, not a claim
  std::vector<std::string> ignored;                           // kinds of disagreements that do not count
  std::function<bool()> is_cancelled = [] { return false; };  // if true, a run throws MachineFailure
};

// The name under which a disagreement has the text of a claim.
inline constexpr char kClaimName[] = "the claim";
inline constexpr char kPeerProperty[] = "against";
inline constexpr char kPeerPairsProperty[] = "persistence-against";

// All kinds of disagreements with a command.
[[nodiscard]] std::vector<std::string> peer_kinds();

// Each run has a folder of its own, below a temporary one that goes when the last copy of the property does. Several
// processes may use it at once, even forked ones that end without unwinding.
[[nodiscard]] property::Property peer_property(const PeerOptions& options);

}  // namespace flowcert::judge
