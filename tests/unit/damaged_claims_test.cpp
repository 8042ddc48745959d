// Claims of every format, damaged: cut at every byte, bytes changed, words replaced by what a reader may fall
// over, lines doubled and swapped. Each gives a claim or one line that says why not, soon and in little
// memory.
#include <sys/resource.h>

#include <array>
#include <chrono>
#include <random>

#include "tests/cites.h"
#include "tests/run_scale.h"
#include "tests/unit/claim_file_samples.h"

namespace flowcert::damaged_claims_test {
namespace {

struct Seed {
  const char* name;
  std::string bytes;
  bool refused_when_cut;  // at every cut, except in white space at the end
};

std::vector<Seed> seeds() {
  return {{"exchange", property::exchange_file({{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}}), false},
          {"whole complex",
           property::exchange_file({{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}},
                                   {.all = true, .volumes = WrittenVolumes::kExact}),
           false},
          {"csv", csv_file(), false},
          {"giesen-kuehne", giesen_kuehne_file(), false},
          {"vtp ascii", vtp_file({}), true},
          {"vtp base64", vtp_file({.encoding = "base64"}), true},
          {"vtp zlib", vtp_file({.encoding = "base64", .compressed = true, .long_header = true}), true},
          {"vtp appended", vtp_file({.encoding = "appended base64", .big_endian = true}), true},
          {"vtp raw", vtp_file({.encoding = "appended raw", .compressed = true}), true},
          {"vtp raw plain", vtp_file({.encoding = "appended raw", .doubles = false, .types = "Int8"}), true},
          {"gzip", gzipped(giesen_kuehne_file()), true}};
}

// How a run of damaged files went.
struct Tally {
  std::size_t read = 0;
  std::size_t refused = 0;
  std::chrono::steady_clock::duration slowest{};
};

// A claim is right, and so is a refusal in one line. Nothing else is.
void expect_claim_or_line(const std::string& bytes, Tally& tally) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const Claim claim = read_claim_from(bytes, "a");
    EXPECT_LE(claim.points.size(), bytes.size() * 1032);
    for (const ClaimedPoint& point : claim.points) {
      EXPECT_TRUE(point.index >= 0 && point.index <= 3);
      EXPECT_TRUE(point.center || !point.contact.empty());
      for (const PointId id : point.contact) EXPECT_LE(id, 2147483646U);
      if (point.squared_distance) {
        EXPECT_GE(point.squared_distance->value, 0);
      }
      if (point.u2) {
        EXPECT_EQ(point.u2->size(), 2U);
      }
    }
    ++tally.read;
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with("a:") && message.size() < 300) << message;
    ++tally.refused;
  }
  tally.slowest = std::max(tally.slowest, std::chrono::steady_clock::now() - start);
}

void expect_soon(const Tally& tally) { EXPECT_LT(std::chrono::duration<double>(tally.slowest).count(), 5.0); }

TEST(DamagedClaims, CutAnywhere) {
  CITES("FC-IN-05");
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.name);
    Tally tally;
    expect_claim_or_line(seed.bytes, tally);
    ASSERT_EQ(tally.read, 1U);
    const std::size_t end = seed.bytes.find_last_not_of('\n') + 1;
    for (std::size_t cut = 0; cut < end; ++cut) expect_claim_or_line(seed.bytes.substr(0, cut), tally);
    EXPECT_GT(tally.refused, 0U);
    if (seed.refused_when_cut) {
      EXPECT_EQ(tally.refused, end);
    }
    expect_soon(tally);
  }
}

TEST(DamagedClaims, EveryByteChanged) {
  CITES("FC-IN-01", "FC-IN-05");
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.name);
    Tally tally;
    for (std::size_t place = 0; place < seed.bytes.size(); ++place) {
      // One of them at each place, in turn, and all in a whole run.
      constexpr std::array kFlips = {'\x01', '\x10', '\x40', '\x7f'};
      for (std::size_t k = 0; k < kFlips.size(); ++k) {
        if (!flowcert_tests::is_whole_run() && (place + k) % kFlips.size() != 0) continue;
        std::string bytes = seed.bytes;
        bytes[place] = static_cast<char>(bytes[place] ^ kFlips[k]);
        expect_claim_or_line(bytes, tally);
      }
    }
    EXPECT_GT(tally.refused, 0U);
    expect_soon(tally);
  }
}

// Words: what is between the bytes that structure the formats.
bool is_of_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '-' ||
         c == '+' || c == '/';
}

const std::vector<std::string> kWords = {"",
                                         "-1",
                                         "0.5",
                                         "1e999",
                                         "1e999999999999",
                                         "1e-999999999999",
                                         "4294967296",
                                         "1000000000000000000",
                                         "18446744073709551615",
                                         "99999999999999999999999999",
                                         "nan",
                                         "-inf",
                                         "1/0",
                                         "0x1p99999",
                                         "null",
                                         "{}",
                                         "[[[[[[[[[[[[[[[[[[[[[[[[",
                                         "\"x\"",
                                         "<!DOCTYPE a>",
                                         "|",
                                         std::string(100000, '7')};

TEST(DamagedClaims, EveryWordReplaced) {
  CITES("FC-IN-01", "FC-IN-05");
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.name);
    Tally tally;
    std::size_t place = 0;
    for (std::size_t from = 0; from < seed.bytes.size();) {
      std::size_t to = from;
      while (to < seed.bytes.size() && is_of_word(seed.bytes[to])) ++to;
      if (to > from) {
        // Every third of them, from another one on at each place, and all in a whole run.
        const std::size_t step = flowcert_tests::is_whole_run() ? 1 : 3;
        for (std::size_t k = place++ % step; k < kWords.size(); k += step)
          expect_claim_or_line(seed.bytes.substr(0, from) + kWords[k] + seed.bytes.substr(to), tally);
      }
      from = to + 1;
    }
    EXPECT_GT(tally.refused, 0U);
    expect_soon(tally);
  }
}

std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  std::istringstream in(bytes);
  std::string line;
  while (std::getline(in, line)) lines.push_back(line + "\n");
  return lines;
}

TEST(DamagedClaims, LinesDoubledDroppedAndSwapped) {
  CITES("FC-IN-05");
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.name);
    Tally tally;
    const std::vector<std::string> lines = lines_of(seed.bytes);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      std::vector<std::string> doubled = lines;
      doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(k), lines[k]);
      std::vector<std::string> dropped = lines;
      dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(k));
      std::vector<std::string> swapped = lines;
      std::swap(swapped[k], swapped[(k + 1) % lines.size()]);
      for (const std::vector<std::string>& changed : {doubled, dropped, swapped}) {
        std::string bytes;
        for (const std::string& line : changed) bytes += line;
        expect_claim_or_line(bytes, tally);
      }
    }
    expect_soon(tally);
  }
}

TEST(DamagedClaims, AtRandom) {
  CITES("FC-IN-01", "FC-IN-05");
  const std::string meaningful = "0123456789.-+eExXp#/|, \t\n\"{}[]:<>=_infal\x1f\x8b\xff\x80";
  const std::vector<Seed> originals = seeds();
  std::mt19937_64 random(20);
  Tally tally;
  for (std::size_t round = 0; round < 20000; ++round) {
    std::string bytes = originals[round % originals.size()].bytes;
    for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t place = bytes.empty() ? 0 : random() % bytes.size();
      const char byte = meaningful[random() % meaningful.size()];
      switch (random() % 4) {
        case 0:
          bytes.insert(place, 1 + random() % 3, byte);
          break;
        case 1:
          bytes.erase(place, 1 + random() % 30);
          break;
        case 2:
          bytes.insert(place, bytes.substr(random() % (bytes.size() + 1), random() % 200));
          break;
        default:
          if (!bytes.empty()) bytes[place] = byte;
      }
    }
    expect_claim_or_line(bytes, tally);
  }
  EXPECT_GT(tally.read, 1000U);
  EXPECT_GT(tally.refused, 1000U);
  expect_soon(tally);
}

// Large files that are cheap to make and could be dear to read.
TEST(DamagedClaims, LargeAndHostile) {
  CITES("FC-IN-05");
  constexpr std::size_t kSize = 1000000;
  const std::string header = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";
  const auto many = [](const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t k = 0; k < count; ++k) text += part;
    return text;
  };
  std::string keys = "{\"index\":1";
  for (std::size_t k = 0; k < kSize / 10; ++k) keys += ",\"" + std::to_string(k) + "\":0";
  std::string elements = "<VTKFile type=\"PolyData\"><PolyData>";
  for (std::size_t k = 0; k < kSize / 10; ++k) elements += "<a" + std::to_string(k) + "/>";
  const std::string digits(kSize - 10, '3');
  std::string fraction = header + "{\"index\":1,\"center\":[\"0\",\"0\",\"";
  fraction.append(digits).append("/7").append(digits).append("\"]}");
  Tally tally;
  for (const std::string& bytes :
       {std::string(kSize, '{'), header + std::string(kSize, '['), header + keys + "}",
        header + "{\"index\":1,\"contact\":[" + many("1,", kSize / 2) + "1]}",
        header + "{\"index\":1,\"x\":[" + many("[],", kSize / 3) + "1]}",
        header + "{\"index\":1,\"x\":\"" + many("\\u0000", kSize / 6) + "\"}", fraction, many("<a>", kSize / 3),
        elements + "</PolyData></VTKFile>", "<VTKFile type=\"" + std::string(kSize, 'a'),
        "<VTKFile type=\"PolyData\"" + many(" a=\"\"", kSize / 5) + "/>", std::string(kSize, '\r') + "x",
        std::string(kSize, '|'), "1 | 1" + many("|inf", kSize / 4), many("1 ", kSize / 2) + "|",
        "1,0,0,0,0" + std::string(kSize, ','), "inf 3" + many("\n1|0", kSize / 10),
        gzipped(std::string(50 * kSize, ' ')), std::string(kSize, '\0')}) {
    expect_claim_or_line(bytes, tally);
  }
  expect_soon(tally);
#ifndef __SANITIZE_ADDRESS__
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 500 * 1024);  // in KB, of the whole test
#endif
}

}  // namespace
}  // namespace flowcert::damaged_claims_test
