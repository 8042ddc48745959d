// The function that fuzzers call: it prints a complaint and aborts, which is how they notice one.
//
// Guarantees: returns iff there is no complaint.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string complaint = flowcert::fuzz::complaint_of({data, size});
  if (!complaint.empty()) {
    std::fputs((complaint + "\n").c_str(), stderr);
    std::abort();
  }
  return 0;
}
