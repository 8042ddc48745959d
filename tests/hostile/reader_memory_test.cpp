// What readers of points and claims take while they read: at most four times the bytes of the file and of what they
// return, plus 16 MB.
//
// Guarantees: every allocation of the program is counted, by new and by GMP; nothing depends on the system.
#include <gmp.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>

#include "certify/pair_claim.h"
#include "flowcert/claim.h"
#include "flowcert/read_balls.h"
#include "flowcert/read_points.h"
#include "tests/cites.h"

namespace {

std::atomic<std::size_t> in_use{0}, most_in_use{0};

void* counted(void* memory) {
  if (memory == nullptr) std::abort();
  const std::size_t now = in_use += ::malloc_usable_size(memory);
  std::size_t most = most_in_use;
  while (now > most && !most_in_use.compare_exchange_weak(most, now)) {
  }
  return memory;
}
void* take(std::size_t bytes) { return counted(std::malloc(std::max<std::size_t>(bytes, 1))); }
void give_back(void* memory) {
  if (memory != nullptr) in_use -= ::malloc_usable_size(memory);
  std::free(memory);
}
void* take_more(void* memory, std::size_t, std::size_t bytes) {
  in_use -= ::malloc_usable_size(memory);
  return counted(std::realloc(memory, bytes));
}

}  // namespace

void* operator new(std::size_t bytes) { return take(bytes); }
void* operator new[](std::size_t bytes) { return take(bytes); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }

namespace flowcert::reader_memory_test {
namespace {

constexpr std::size_t kRows = 40'000, kTimes = 4, kAlways = std::size_t{16} << 20;

// `read` returns what it keeps.
template <class Read>
void expect_little(const std::string& what, std::size_t file, const Read& read) {
  const std::size_t before = in_use;
  most_in_use = before;
  const auto result = read();
  const std::size_t kept = in_use - before + file, most = most_in_use - before;
  EXPECT_LE(most, kTimes * kept + kAlways) << what << ": " << file << " bytes of a file, " << kept - file << " kept";
}

std::string repeated(const std::string& head, const std::string& row, std::size_t rows, const std::string& end = "") {
  std::string text = head;
  for (std::size_t k = 0; k < rows; ++k) text += row;
  return text + end;
}

std::string binary(const std::string& head, std::size_t rows) { return head + std::string(rows * 24, '\0'); }

std::string npy() {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(kRows) + ", 3), }";
  header += std::string(118 - header.size() - 1, ' ') + '\n';
  return binary(std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header, kRows);
}

TEST(ReaderMemory, OfPoints) {
  CITES("FC-IN-05");
  mp_set_memory_functions(take, take_more, [](void* memory, std::size_t) { give_back(memory); });
  const std::string count = std::to_string(kRows);
  const std::pair<const char*, std::string> files[] = {
      {"short rows", repeated("", "0 0 0\n", 8 * kRows)},
      {"rows", repeated("", "0.123456789 1.23456789 -2.3456789\n", kRows)},
      {"csv", repeated("name,x,y,z\n", "a,0.5,1.5,2.5\n", kRows)},
      {"chemical", repeated(count + "\ncomment\n", "C 0.5 1.5 2.5\n", kRows)},
      {"off", repeated("OFF\n" + count + " 0 0\n", "0.5 1.5 2.5\n", kRows)},
      {"obj", repeated("", "v 0.5 1.5 2.5\n", kRows)},
      {"ply", repeated("ply\nformat ascii 1.0\nelement vertex " + count +
                           "\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
                       "0.5 1.5 2.5\n", kRows)},
      {"binary ply", binary("ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                                "\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
                            kRows)},
      {"npy", npy()},
      {"pdb", repeated("", "ATOM      1  CA  ALA A   1      11.104   6.134  -6.504  1.00  0.00           C\n", kRows)},
      {"pqr", repeated("", "ATOM 1 CA ALA A 1 11.104 6.134 -6.504 0.1 1.9\n", kRows)},
      {"cif", repeated("data_a\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
                       "_atom_site.label_asym_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n",
                       "ATOM 1 C A 1.5 2.5 3.5\n", kRows)}};
  for (const auto& [what, bytes] : files) {
    expect_little(what, bytes.size(), [&bytes = bytes] { return read_points_from(bytes, "file"); });
    expect_little(what, bytes.size(),
                  [&bytes = bytes] { return read_balls_from(bytes, "file", {}, AtomRadii("1.5")); });
  }
}

TEST(ReaderMemory, OfClaims) {
  CITES("FC-CLAIM-01");
  const std::string header = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";
  const std::pair<const char*, std::string> files[] = {
      {"short csv", repeated("", "0,,,,,0\n", 4 * kRows)},
      {"csv", repeated("", "2,0.5,0.25,0.125,1.5,1,2,3\n", kRows)},
      {"contacts", repeated(header, "{\"index\":0,\"contact\":[0]}\n", kRows)},
      {"centres", repeated(header, "{\"index\":1,\"contact\":[0,1],\"center\":[\"1/3\",\"2/7\",\"5\"]}\n", kRows)},
      {"a long list", header + repeated("{\"index\":1,\"contact\":[", "0,", 20 * kRows, "1]}\n")},
      {"a long polyline",
       header + repeated("{\"index\":2,\"contact\":[0,1,2],\"limits\":[[1],[2]],\"u2\":[[",
                         "{\"type\":\"E-F-V\",\"driver\":[\"1\",\"2\",\"3\"],\"end\":[\"1/3\",\"2\",\"3\"]},", kRows,
                         "{\"type\":\"V-E-V\",\"driver\":[\"1\",\"2\",\"3\"],\"end\":[\"1/3\",\"2\",\"3\"]}],[]]}\n")},
      {"short giesen-kuehne", repeated("", "0 0\n", 4 * kRows)}};
  for (const auto& [what, bytes] : files) {
    expect_little(what, bytes.size(), [&bytes = bytes] {
      try {
        return read_claim_from(bytes, "claim");
      } catch (const InvalidInput&) {
        return Claim{};  // what was kept until then counts
      }
    });
  }
  const std::string pairs = repeated("0 0 inf\n", "1 0.5 0.75\n", 2 * kRows);
  expect_little("pairs", pairs.size(), [&] { return claimed_pairs_of(pairs, "pairs"); });
  const std::string json =
      repeated("{\"format\":\"flowcert-persistence\",\"pairs\":[",
               "{\"dimension\":1,\"birth\":{\"squared_distance\":\"1/3\"},\"death\":{\"squared_distance\":\"2\"}},",
               kRows, "{\"dimension\":0,\"birth\":{\"squared_distance\":\"0\"},\"death\":null}]}");
  expect_little("pairs as JSON", json.size(), [&] { return claimed_pairs_of(json, "pairs"); });
}

}  // namespace
}  // namespace flowcert::reader_memory_test
