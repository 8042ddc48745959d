// flowcert-proof: proves or rejects a Delaunay certificate, and with it all stationary points of the points of a file, a
// list of them, and persistence pairs. Prints what is proved.
//
// Exit status: 0, all that was asked is proved; 1, the certificate is rejected, or the list or the pairs refuted; 2, that
// cannot be decided.
#include <iostream>
#include <optional>

#include "delaunay.h"
#include "list.h"
#include "pairs_file.h"

static void prove(const std::string& scan, const std::string& certificate, const std::optional<std::string>& list,
                  const std::optional<std::string>& pairs) {
  test_rounding();
  const Points points(scan);
  CertificateReader reader(certificate, points);
  const Triangulation triangulation = reader.read();
  const std::vector<std::uint8_t> is_cospherical = DelaunayProof(points, triangulation).prove();
  std::cout << "proved: these " << triangulation.cells.size() << " cells are a Delaunay triangulation of "
            << points.row_count() << " points (" << points.point_count() << " different ones)\n";
  const StationaryPoints stationary(points, triangulation, is_cospherical);
  const auto& n = stationary.counts();
  std::cout << "proved: all " << stationary.all().size() << " stationary points: critical " << n[0] << " " << n[1]
            << " " << n[2] << " " << n[3] << ", regular 1-2: " << n[4] << ", 1-3: " << n[5] << ", 2-3: " << n[6]
            << "\n";
  const auto skip = [](const std::string& file, const std::string& skipped) {
    if (!skipped.empty()) std::cout << "not compared, header of " << file << ": " << skipped << "\n";
  };
  if (list) {
    const auto [fields, skipped] = compare_list(*list, points, stationary);
    std::cout << "proved, line by line of " << *list << ": " << fields << "\nproved, header of " << *list
              << ": points, merged_duplicates, critical, regular_stationary, classes\n";
    skip(*list, skipped);
  }
  if (pairs) {
    const PersistencePairs all(points, triangulation);
    const bool is_json = JsonReader(*pairs).next() == '{';
    const std::string skipped = is_json ? compare_exact(*pairs, points, stationary, all) : "";
    if (!is_json) compare_rounded(*pairs, points, all);
    std::cout << "proved: all " << all.all().size() << " pairs, dimensions 0 to 2, "
              << (is_json ? "exactly\n" : "as nearest doubles\n");
    skip(*pairs, skipped);
  }
  std::cout << (reader.has_hash() ? "hash of the points not compared\n" : "no hash\n");
}

int main(int argc, char** argv) {
  try {
    std::vector<std::string> files;
    std::optional<std::string> pairs;
    for (int k = 1; k < argc; ++k) {
      const std::string word = argv[k];
      if (word == "--pairs" && k + 1 < argc && !pairs) {
        pairs = argv[++k];
      } else if (word.starts_with("-")) {
        files.clear();
        break;
      } else {
        files.push_back(word);
      }
    }
    if (files.size() < 2 || files.size() > 3)
      cannot_decide("usage: flowcert-proof SCAN CERTIFICATE [LIST] [--pairs P]");
    const auto list = files.size() == 3 ? std::optional(files[2]) : std::nullopt;
    prove(files[0], files[1], list, pairs);
    std::cout.flush();
    if (!std::cout) cannot_decide("standard output cannot be written");
    return 0;
  } catch (const Verdict& verdict) {
    (verdict.exit_status == 1 ? std::cout : std::cerr) << verdict.line << std::endl;
    return verdict.exit_status;
  } catch (const std::bad_alloc&) {
    std::cerr << "out of memory" << std::endl;
    return 2;
  }
}
