// See shared_trial.h. Two places take turns: a trial is written to the one that is not the latest.
#include "fuzz/campaign/shared_trial.h"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <sstream>
#include <system_error>

#include "fuzz/campaign/input_json.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kMostNumbers = 64;
constexpr std::size_t kMostText = std::size_t{1} << 20;

struct Place {
  std::uint64_t number = 0;
  std::array<char, 64> source{}, property{};
  std::size_t rows = 0;
  std::array<Row, kMostRowsOfTrial> row{};
  bool has_choice = false;
  property::StartKind kind{};
  std::size_t numbers = 0;
  std::array<std::uint32_t, kMostNumbers> numbers_of_choice{};
  std::array<char, kMostText> start{};
};

template <std::size_t N>
void copy_text(const std::string& text, std::array<char, N>& to) {
  const std::size_t size = std::min(text.size(), N - 1);
  std::copy_n(text.begin(), size, to.begin());
  to[size] = '\0';
}

}  // namespace

struct SharedTrial::Memory {
  std::array<Place, 2> places;
  std::atomic<std::uint64_t> trials{0};  // the latest one is in places[trials % 2]
  std::atomic<bool> is_trying{false};
  std::atomic<std::uint64_t> cases{0};
  std::atomic<bool> stop{false};
};

SharedTrial::SharedTrial() {
  void* memory = ::mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  memory_ = new (memory) Memory;
}

SharedTrial::~SharedTrial() { ::munmap(memory_, sizeof(Memory)); }

void SharedTrial::note(std::size_t number, const std::string& source, const std::string& property,
                       const property::Trial& trial) {
  const std::uint64_t next = memory_->trials + 1;
  Place& place = memory_->places.at(next % 2);
  place.number = number;
  copy_text(source, place.source);
  copy_text(property, place.property);
  place.rows = std::min(trial.input.rows.size(), place.row.size());
  std::copy_n(trial.input.rows.begin(), place.rows, place.row.begin());
  if (const auto* choice = std::get_if<property::StartChoice>(&trial.start)) {
    place.has_choice = true;
    place.kind = choice->kind;
    place.numbers = std::min(choice->numbers.size(), kMostNumbers);
    std::copy_n(choice->numbers.begin(), place.numbers, place.numbers_of_choice.begin());
  } else {
    place.has_choice = false;
    copy_text(to_text(std::get<oracle::Point>(trial.start)), place.start);
  }
  memory_->trials = next;
  memory_->is_trying = true;
}

void SharedTrial::count_case() { ++memory_->cases; }
void SharedTrial::forget() { memory_->is_trying = false; }
void SharedTrial::start_batch() { memory_->cases = 0; }
bool SharedTrial::is_told_to_stop() const { return memory_->stop; }
bool SharedTrial::is_trying() const { return memory_->is_trying; }
std::uint64_t SharedTrial::trials() const { return memory_->trials; }
std::size_t SharedTrial::cases() const { return memory_->cases; }
void SharedTrial::tell_to_stop() { memory_->stop = true; }

NotedTrial SharedTrial::noted() const {
  const Place& place = memory_->places.at(memory_->trials % 2);
  NotedTrial noted{place.number, place.property.data(), place.source.data(), {}};
  noted.trial.input.rows.assign(place.row.begin(),
                                place.row.begin() + static_cast<std::ptrdiff_t>(place.rows));
  if (place.has_choice) {
    const auto* first = place.numbers_of_choice.begin();
    noted.trial.start = property::StartChoice{place.kind, {first, first + place.numbers}};
  } else {
    noted.trial.start = point_of(place.start.data());
  }
  return noted;
}

}  // namespace flowcert::fuzz
