// A precondition is what a header asks of its caller.
//
// Guarantees: FLOWCERT_REQUIRES(condition) ends the program where the condition does not hold, with one line that
// names the condition and its place. It does so in builds with FLOWCERT_CONTRACTS (Debug and sanitizer builds,
// CMakeLists.txt). In other builds the condition is compiled but costs nothing. <cassert> does not serve: its switch,
// NDEBUG, also switches CGAL's own assertions, which take many times as long.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace flowcert::geometry {

[[noreturn]] inline void contract_broken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: a precondition does not hold: %s\n", file, line, condition);
  std::abort();
}

#ifdef FLOWCERT_CONTRACTS
inline constexpr bool kContracts = true;
#else
inline constexpr bool kContracts = false;
#endif

}  // namespace flowcert::geometry

#define FLOWCERT_REQUIRES(...)                          \
  ((!::flowcert::geometry::kContracts || (__VA_ARGS__)) \
       ? void()                                         \
       : ::flowcert::geometry::contract_broken(#__VA_ARGS__, __FILE__, __LINE__))
