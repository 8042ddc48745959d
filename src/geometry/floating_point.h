// The filters' proofs, and every nearest double, assume that this thread computes with doubles as IEEE 754 says: it
// rounds to nearest, keeps subnormals, traps nothing, and fuses no multiply-add. Other libraries set other modes, and
// leave them set for whoever comes next.
//
// Guarantees: while an IeeeDoubles stands, its thread computes so; afterwards the caller's modes are as they were, also
// after an exception. Every public function that computes, compares, reads or writes doubles holds one, and so does
// every part of a parallel loop. What it calls back (a report of progress) sees these modes, too.
#pragma once

#include <cfenv>
#include <optional>

namespace flowcert::geometry {

class IeeeDoubles {
 public:
  // Throws as require_ieee_doubles() where the modes cannot be had. It takes some nanoseconds if they stand already.
  IeeeDoubles();
  ~IeeeDoubles();
  IeeeDoubles(const IeeeDoubles&) = delete;
  IeeeDoubles& operator=(const IeeeDoubles&) = delete;

 private:
  std::optional<std::fenv_t> before_;
};

// For constructors, which compute before their body begins.
auto in_ieee_doubles(const auto& call) {
  const IeeeDoubles ieee;
  return call();
}

// Throws std::runtime_error, with one line that says what is wrong.
void require_ieee_doubles();

}  // namespace flowcert::geometry
