// flowcert-make-vectors FOLDER [GROUP…]: writes the conformance vectors, one file a group, and flags.json. Those of
// balls are the group pores, which comes into the folder balls/.
//
// Takes some minutes: the oracle searches all subsets of up to 60 points. Prints a table of groups and flags.
// Exit status: 0, or 2 where a file cannot be written or there is no such group.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "tests/vectors/flags.h"
#include "tests/vectors/pore_vectors.h"
#include "tests/vectors/vectors.h"

namespace {

using oracle::Json;
using oracle::vectors::Group;

struct Counts {
  std::size_t cases = 0;
  std::map<std::string, std::size_t> flags;
  std::map<std::string, std::size_t> results;
  std::map<std::string, std::size_t> types;  // of flow segments
};

std::size_t write(const std::filesystem::path& path, const Json& file) {
  const std::string text = oracle::vectors::text_of(file);
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
  return text.size();
}

void count(const Json& made, Counts& counts) {
  ++counts.cases;
  ++counts.results[made["result"]];
  for (const Json& flag : made["flags"]) ++counts.flags[flag];
  if (!made.contains("expected") || !made["expected"].contains("orbits")) return;
  for (const Json& path : made["expected"]["orbits"]) {
    for (const Json& segment : path["segments"]) ++counts.types[segment["type"]];
  }
}

constexpr char kPores[] = "pores";

// `cases_of` makes the cases, and `file_of` the file of them.
template <class CasesOf, class FileOf>
void make(const std::string& name, const std::filesystem::path& path, const CasesOf& cases_of, const FileOf& file_of,
          Counts& counts) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Json> cases = cases_of();
  for (const Json& made : cases) count(made, counts);
  const std::size_t size = write(path, file_of(cases));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%-28s %4zu cases %9zu bytes %7.1f s\n", name.c_str(), cases.size(), size, seconds.count());
  std::fflush(stdout);
}

void make(const Group& group, const std::filesystem::path& folder, Counts& counts) {
  const auto cases_of = [&] {
    std::vector<Json> cases;
    cases.reserve(group.recipes.size() + group.invalid_recipes.size());
    for (const auto& recipe : group.recipes) cases.push_back(oracle::vectors::case_of(group, recipe));
    for (const auto& recipe : group.invalid_recipes) cases.push_back(oracle::vectors::case_of(group, recipe));
    return cases;
  };
  make(
      group.name, folder / (group.name + ".json"), cases_of,
      [&](const std::vector<Json>& cases) { return oracle::vectors::group_file(group, cases); }, counts);
}

void make_pores(const std::filesystem::path& folder, Counts& counts) {
  const auto cases_of = [] {
    std::vector<Json> cases;
    for (const auto& recipe : oracle::vectors::pore_recipes()) cases.push_back(oracle::vectors::pore_case(recipe));
    return cases;
  };
  std::filesystem::create_directories(folder / "balls");
  make(kPores, folder / "balls" / "pores.json", cases_of, oracle::vectors::pore_file, counts);
}

void require_group(const std::string& name) {
  if (name == kPores) return;
  for (const Group& group : oracle::vectors::groups()) {
    if (group.name == name) return;
  }
  throw std::runtime_error("there is no group " + name);
}

void print(const char* what, const std::map<std::string, std::size_t>& counts) {
  std::printf("%s\n", what);
  for (const auto& [name, number] : counts) std::printf("  %-26s %4zu\n", name.c_str(), number);
}

int run(const std::vector<std::string>& words) {
  if (words.empty() || words[0].starts_with('-')) {
    std::fputs("usage: flowcert-make-vectors FOLDER [GROUP...]\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = words[0];
  const std::vector<std::string> wanted(words.begin() + 1, words.end());
  for (const std::string& name : wanted) require_group(name);
  const auto is_wanted = [&](const std::string& name) {
    return wanted.empty() || std::count(wanted.begin(), wanted.end(), name) > 0;
  };
  Counts counts;
  for (const Group& group : oracle::vectors::groups()) {
    if (is_wanted(group.name)) make(group, folder, counts);
  }
  if (is_wanted(kPores)) make_pores(folder, counts);
  write(folder / "flags.json", oracle::vectors::flag_file());
  std::printf("%-28s %4zu cases\n", "all", counts.cases);
  print("results", counts.results);
  print("flags", counts.flags);
  print("segments of given orbits", counts.types);
  for (const auto& flag : oracle::vectors::all_flags()) {
    if (wanted.empty() && !counts.flags.contains(flag.name)) {
      std::printf("no case has the flag %s\n", flag.name);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flowcert-make-vectors: %s\n", error.what());
    return 2;
  }
}
