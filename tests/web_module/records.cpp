// What Node's tests compare with the program: all parts of the complex of each file, as records and as persistence.
//
// usage: flowcert_records FOLDER WHAT FILE…: writes FOLDER/NAME.jsonl and FOLDER/NAME.pers for each FILE, …/NAME.xyz,
// and prints one JSON object: the seconds of each part and of writing, the bytes of memory after it, or what is wrong.
// WHAT: "lines", with polylines and skeletons, which are gigabytes for a scan; "records", without; "pairs", the second
// file alone.
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "flowcert/write_persistence.h"
#include "flowcert/write_stationary_points.h"

namespace {

using namespace flowcert;
using Json = nlohmann::ordered_json;

// The limits of all directions come late, because they take the most memory.
constexpr std::pair<FlowComplexPart, const char*> kParts[] = {{FlowComplexPart::kTriangulation, "delaunay"},
                                                              {FlowComplexPart::kStationary, "critical"},
                                                              {FlowComplexPart::kStable, "s2"},
                                                              {FlowComplexPart::kUnstable, "u2"},
                                                              {FlowComplexPart::kPersistence, "pairs"},
                                                              {FlowComplexPart::kLimits, "limits"},
                                                              {FlowComplexPart::kVolumes, "volumes"}};

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t bytes_of_memory() { return __builtin_wasm_memory_size(0) << 16; }

Json written(const std::filesystem::path& folder, const std::string& file, std::string_view what) {
  const FlowComplex complex(PointSet(read_points(file).rows));
  Json seconds, memory{{"read", bytes_of_memory()}};
  for (const auto& [part, name] : kParts) {
    seconds[name] = seconds_of([&] { complex.make(part); });
    memory[name] = bytes_of_memory();
  }
  const std::filesystem::path stem = folder / std::filesystem::path(file).stem();
  const bool has_lines = what == "lines";
  seconds["records"] = seconds_of([&] {
    if (what == "pairs") return;
    std::ofstream out(stem.string() + ".jsonl", std::ios::binary);
    write_stationary_points(out, complex,
                            {.u2 = true, .polylines = has_lines, .s2 = true, .skeletons = has_lines, .all = true});
  });
  std::ofstream(stem.string() + ".pers", std::ios::binary) << pers_text(PersistenceDiagram(complex, false));
  memory["written"] = bytes_of_memory();
  return {{"file", file}, {"seconds", seconds}, {"memory", memory}};
}

}  // namespace

int main(int count, char** words) {
  for (int k = 3; k < count; ++k) {
    Json said;
    try {
      said = written(words[1], words[k], words[2]);
    } catch (const std::exception& error) {
      said = {{"file", words[k]}, {"error", error.what()}};
    }
    std::puts(said.dump().c_str());
  }
}
