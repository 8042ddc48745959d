// The trial that a worker process is at, in memory that it shares with its parent: what is left to know of it
// if it ends there.
//
// Guarantees: whatever the process dies of, the trial noted last can be read by the parent, whole.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/campaign/campaign_plan.h"
#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

struct NotedTrial {
  std::size_t number = 0;
  std::string property;
  std::string source;
  property::Trial trial;
};

class SharedTrial {
 public:
  SharedTrial();
  ~SharedTrial();
  SharedTrial(const SharedTrial&) = delete;
  SharedTrial& operator=(const SharedTrial&) = delete;

  // By the worker.
  void note(std::size_t number, const std::string& source, const std::string& property,
            const property::Trial& trial);
  void count_case();
  void forget();  // nothing is being tried
  void start_batch();
  [[nodiscard]] bool is_told_to_stop() const;

  // By the parent.
  [[nodiscard]] bool is_trying() const;
  [[nodiscard]] NotedTrial noted() const;
  // Changes with every trial.
  [[nodiscard]] std::uint64_t trials() const;
  // Cases done in the batch under way.
  [[nodiscard]] std::size_t cases() const;
  void tell_to_stop();

 private:
  struct Memory;
  Memory* memory_;
};

}  // namespace flowcert::fuzz
