// A target without a fuzzer: it runs on the named files, and on the files of the named folders.
//
// Guarantees: exit status 0 iff there were files, all could be read, and all of them passed. It prints the name of
// each file, and aborts at the first that does not pass. The files of a folder are taken in the order of their names.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::set<fs::path> files_at(const fs::path& place) {
  std::set<fs::path> files;
  if (!fs::is_directory(place)) return {place};
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  return files;
}

bool replay(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file.is_open() || file.bad()) {
    std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
    return false;
  }
  std::fprintf(stderr, "%s (%zu bytes)\n", path.c_str(), bytes.size());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  std::size_t replayed = 0;
  bool all_read = true;
  for (int k = 1; k < count; ++k) {
    for (const fs::path& path : files_at(arguments[k])) {
      all_read = replay(path) && all_read;
      ++replayed;
    }
  }
  std::fprintf(stderr, "%zu files replayed\n", replayed);
  return all_read && replayed > 0 ? 0 : 1;
}
