// flowcert-proof: proves or rejects a Delaunay certificate, and with it all stationary points of the points of a file,
// a list of them, and persistence pairs. It prints what is proved.
//
// Exit status: 0, all that was asked is proved; 1, the certificate is rejected, or the list or the pairs refuted; 2,
// that cannot be decided.
#include <iostream>
#include <optional>

#include "delaunay.h"
#include "list.h"
#include "pairs_file.h"

#ifndef FLOWCERT_VERSION
#define FLOWCERT_VERSION "unknown"  // where this file is compiled alone
#endif

constexpr char kUsage[] = "usage: flowcert-proof SCAN CERTIFICATE [LIST] [--pairs P]";
constexpr char kHelp[] =
    "\n\nProves that the cells of CERTIFICATE are a Delaunay triangulation of the points\n"
    "of SCAN, and by them which stationary points and persistence pairs there are.\n\n"
    "  SCAN         Points: .xyz, or as flowcert points writes them\n"
    "  CERTIFICATE  Cells, as compute --certificate writes them\n"
    "  LIST         Stationary points, as compute -o writes them\n"
    "  --pairs P    Persistence pairs, as persistence -o or --json writes them\n"
    "  --help       Print this\n"
    "  --version    Print the version\n\n"
    "Exit status: 0, all that was asked is proved; 1, CERTIFICATE is rejected, or\n"
    "LIST or P refuted; 2, that cannot be decided.\n";

// Files that are not given are empty.
static void prove(const std::string& scan, const std::string& certificate, const std::string& list,
                  const std::string& pairs) {
  test_rounding();
  const Points points(scan);
  CertificateReader reader(certificate, bytes_of_file(certificate), points);
  const Triangulation triangulation = reader.read();
  const std::vector<std::uint8_t> is_cospherical = DelaunayProof(points, triangulation).prove();
  std::cout << "proved: these " << triangulation.cells.size() << " cells are a Delaunay triangulation of "
            << points.row_count() << " points (" << points.point_count() << " different ones)\n";
  std::optional<StationaryPoints> stationary(std::in_place, points, triangulation, is_cospherical);
  const auto& n = stationary->counts();
  std::cout << "proved: all " << stationary->all().size() << " stationary points: critical " << n[0] << " " << n[1]
            << " " << n[2] << " " << n[3] << ", regular 1-2: " << n[4] << ", 1-3: " << n[5] << ", 2-3: " << n[6]
            << "\n";
  if (!list.empty()) {
    const auto [fields, skipped] = compare_list(list, points, *stationary);
    std::cout << "proved, line by line of " << list << ": " << fields << "\nproved, header of " << list
              << ": points, merged_duplicates, critical, regular_stationary, classes\n";
    if (!skipped.empty()) std::cout << "not compared, header of " << list << ": " << skipped << "\n";
  }
  if (!pairs.empty()) {
    const bool is_json = JsonReader(pairs).next() == '{';
    if (!is_json) stationary.reset();  // for memory
    const PersistencePairs all(points, triangulation);
    const std::string skipped = is_json ? compare_exact(pairs, points, *stationary, all) : "";
    if (!is_json) compare_rounded(pairs, points, all);
    std::cout << "proved: all " << all.all().size() << " pairs, dimensions 0 to 2, "
              << (is_json ? "exactly\n" : "as nearest doubles\n");
    if (!skipped.empty()) std::cout << "not compared, header of " << pairs << ": " << skipped << "\n";
  }
  std::cout << (reader.has_hash() ? "hash of the points not compared\n" : "no hash\n");
}

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  std::string pairs;
  const auto option = std::find(words.begin(), words.end(), "--pairs");
  if (words.end() - option > 1) {
    pairs = option[1];
    words.erase(option, option + 2);
  }
  try {
    const std::string alone = words.size() == 1 ? words[0] : "";
    if (alone == "--help") {
      std::cout << kUsage << kHelp;
    } else if (alone == "--version") {
      std::cout << "flowcert-proof " FLOWCERT_VERSION "\n";
    } else {
      const bool has_option = std::any_of(words.begin(), words.end(), [](auto& word) { return word.starts_with("-"); });
      if (words.size() < 2 || words.size() > 3 || has_option) cannot_decide(kUsage);
      prove(words[0], words[1], words.size() > 2 ? words[2] : "", pairs);
    }
    std::cout << std::flush;
    if (!std::cout) cannot_decide("standard output cannot be written");
    return 0;
  } catch (const Verdict& verdict) {
    (verdict.exit_status == 1 ? std::cout : std::cerr) << verdict.line << std::endl;
    return verdict.exit_status;
  } catch (const std::bad_alloc&) {
    std::cerr << "out of memory" << std::endl;
    return 2;
  } catch (const std::runtime_error& failure) {  // the system cannot read, or has no random bits
    std::cerr << failure.what() << std::endl;
    return 2;
  }
}
