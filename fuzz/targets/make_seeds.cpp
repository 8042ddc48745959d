// Writes the seeds of the targets that eat points, as files in a folder: `make_seeds TARGET FOLDER XYZ…`.
//
// Guarantees: the same files every time. The seeds are small inputs of the families and the named files, if bytes can
// say them (byte_input.h). For orbits, each begins with the bytes of a start, of one kind after the other.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "flowcert/read_points.h"
#include "fuzz/inputs/byte_input.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kMostRows = 12;
constexpr std::uint64_t kTries = 40;
constexpr int kSize = 60;

// A choice as orbit.cpp reads it: a kind, and seven numbers.
std::string start_number(unsigned number) {
  std::string bytes = {static_cast<char>(number % 10)};
  for (unsigned k = 1; k < 8; ++k) bytes += static_cast<char>((number * 29 + k * 67) % 256);
  return bytes;
}

class Folder {
 public:
  Folder(std::filesystem::path path, bool has_starts) : path_(std::move(path)), has_starts_(has_starts) {
    std::filesystem::create_directories(path_);
  }
  bool add(const std::string& name, const Input& input) {
    const auto bytes = bytes_of_input(input);
    if (!bytes) return false;
    std::ofstream file(path_ / name, std::ios::binary);
    if (has_starts_) file << start_number(count_);
    file.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    ++count_;
    return true;
  }

 private:
  std::filesystem::path path_;
  bool has_starts_;
  unsigned count_ = 0;
};

// The first input that is neither tiny nor too large, and that bytes can say.
void add_one_of(const Family& family, std::size_t most_rows, Folder& folder) {
  for (std::uint64_t seed = 1; seed <= kTries; ++seed) {
    const Input input = draw(family, seed, kSize);
    if (input.rows.size() < 4 || input.rows.size() > most_rows) continue;
    if (folder.add(family.name, input)) return;
  }
}

void make_seeds(const std::string& target, const std::string& path, int files, char** names) {
  const std::size_t most_rows = target == "critical_points" ? kMostRows : target == "orbit" ? 10 : 8;
  Folder folder(path, target == "orbit");
  folder.add("nothing", {});
  folder.add("one-point", {{{1, 2, 3}}});
  folder.add("repeated-point", {{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}}});
  for (const auto& family : families()) add_one_of(family, most_rows, folder);
  for (const auto& family : stable_families()) add_one_of(family, most_rows, folder);
  for (int k = 0; k < files; ++k) {
    folder.add(std::filesystem::path(names[k]).stem().string(), property::input_of(read_points(names[k]).rows));
  }
}

}  // namespace
}  // namespace flowcert::fuzz

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: make_seeds critical_points|orbit|stable_sets|write_exchange FOLDER XYZ...\n");
    return 2;
  }
  flowcert::fuzz::make_seeds(arguments[1], arguments[2], count - 3, arguments + 3);
  return 0;
}
