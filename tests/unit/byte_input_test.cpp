// Bytes as inputs: every byte string is an input, random ones often have ties, and lattice inputs can be
// written as bytes.
#include "fuzz/inputs/byte_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "oracle/stationary_points.h"
#include "tests/unit/portable_random.h"

namespace flowcert::fuzz::byte_input_test {
namespace {

using ByteString = std::vector<std::uint8_t>;
using flowcert_tests::PortableRandom;

ByteString random_bytes(PortableRandom& random, std::size_t size) {
  ByteString bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

TEST(ByteInput, EveryByteStringIsAnInput) {
  PortableRandom random(5);
  for (int round = 0; round < 5000; ++round) {
    const ByteString bytes = random_bytes(random, random.below(70));
    const std::size_t most_rows = random.below(13);
    const Input input = input_of_bytes(bytes, most_rows);
    EXPECT_EQ(input.rows.size(), bytes.empty() ? 0U : std::min((bytes.size() - 1) / 4, most_rows));
    for (const Row& row : input.rows) {
      for (const double x : row) EXPECT_TRUE(std::isfinite(x));
    }
  }
}

TEST(ByteInput, EveryHeaderHasItsOwnLattice) {
  // The rows are at the corners of what a lattice can have.
  const ByteString rows = {255, 0, 7, 0, 126, 254, 1, 0xc9, 3, 200, 90, 0xd2};
  std::set<std::vector<Row>> seen;
  for (unsigned header = 0; header < 256; ++header) {
    ByteString bytes = {static_cast<std::uint8_t>(header)};
    bytes.insert(bytes.end(), rows.begin(), rows.end());
    const Input input = input_of_bytes(bytes, 12);
    ASSERT_EQ(input.rows.size(), 3U);
    for (const Row& row : input.rows) {
      for (const double x : row) EXPECT_TRUE(std::isfinite(x)) << header;
    }
    EXPECT_TRUE(seen.insert(input.rows).second) << header;
  }
}

TEST(ByteInput, LayoutIsAsDescribed) {
  // Half width 1, unit 2^0, near, without ulps. The bits for ulps in a row do not count then.
  EXPECT_EQ(input_of_bytes(ByteString{0x00, 0, 1, 2, 0xff, 3, 4, 5, 0}, 12), (Input{{{-1, 0, 1}, {-1, 0, 1}}}));
  // With ulps, which the rows with bits 6 and 7 have.
  const double up = std::nextafter(1.0, 2.0);
  const double down = std::nextafter(1.0, 0.0);
  EXPECT_EQ(input_of_bytes(ByteString{0x80, 2, 2, 2, 0xc9, 2, 2, 2, 0x49}, 12), (Input{{{up, down, 1}, {1, 1, 1}}}));
  // Half width 2, unit 2^-2; far from the origin.
  EXPECT_EQ(input_of_bytes(ByteString{0x09, 0, 1, 4, 0}, 12), (Input{{{-0.5, -0.25, 0.5}}}));
  EXPECT_EQ(input_of_bytes(ByteString{0x41, 2, 3, 4, 0}, 12), (Input{{{0x1p40, -0x1p41 + 1, 0x1p39 + 2}}}));
  // An image of the first row (x and y exchanged, x negative); the row itself. A first row is read as usual.
  EXPECT_EQ(input_of_bytes(ByteString{0x01, 4, 3, 2, 0, 0, 25, 9, 0x80}, 12), (Input{{{2, 1, 0}, {-1, 2, 0}}}));
  EXPECT_EQ(input_of_bytes(ByteString{0x01, 4, 3, 2, 0x80, 7, 63, 9, 0xbf}, 12), (Input{{{2, 1, 0}, {2, 1, 0}}}));
  // Bytes that are left over do not count, nor do rows beyond the limit.
  EXPECT_EQ(input_of_bytes(ByteString{0x00, 1, 1, 1, 0, 0, 0}, 12), (Input{{{0, 0, 0}}}));
  EXPECT_EQ(input_of_bytes(ByteString{0x00, 1, 1, 1, 0, 0, 0, 0, 0}, 1), (Input{{{0, 0, 0}}}));
}

// What a random input of four to nine rows is like, in percent.
struct Shares {
  int duplicates = 0;
  int near_ties = 0;  // ulps
  int ties = 0;       // contact sets that are no simplices, and regular stationary points
  int four_points = 0;
};

bool is_tie(const oracle::StationaryPoint& x) {
  return x.face_dimension != x.hull_dimension || x.contact.size() > static_cast<std::size_t>(x.hull_dimension) + 1;
}

Shares shares_of_random_inputs() {
  constexpr int kInputs = 200;
  PortableRandom random(11);
  Shares count;
  for (int round = 0; round < kInputs; ++round) {
    const ByteString bytes = random_bytes(random, 1 + 4 * (4 + random.below(6)));
    const Input input = input_of_bytes(bytes, 12);
    const oracle::Answer answer = oracle::stationary_points(input.rows);
    ByteString without_ulps = bytes;
    without_ulps[0] &= 0x7fU;
    count.duplicates += answer.merged_duplicates > 0 ? 1 : 0;
    count.four_points += answer.points - answer.merged_duplicates >= 4 ? 1 : 0;
    count.near_ties += input == input_of_bytes(without_ulps, 12) ? 0 : 1;
    count.ties += std::any_of(answer.stationary.begin(), answer.stationary.end(), is_tie) ? 1 : 0;
  }
  for (int* share : {&count.duplicates, &count.near_ties, &count.ties, &count.four_points}) {
    *share = *share * 100 / kInputs;
  }
  std::printf("duplicates %d %%, ulps %d %%, ties %d %%, four points %d %%\n", count.duplicates, count.near_ties,
              count.ties, count.four_points);
  return count;
}

TEST(ByteInput, TiesAreCommon) {
  const Shares shares = shares_of_random_inputs();
  EXPECT_GE(shares.duplicates, 20);
  EXPECT_GE(shares.near_ties, 25);
  EXPECT_GE(shares.ties, 25);
  EXPECT_GE(shares.four_points, 80);
}

TEST(ByteInput, WhatWasDecodedCanBeEncoded) {
  PortableRandom random(17);
  for (int round = 0; round < 2000; ++round) {
    const Input input = input_of_bytes(random_bytes(random, random.below(50)), 12);
    const auto bytes = bytes_of_input(input);
    ASSERT_TRUE(bytes.has_value()) << input;
    EXPECT_EQ(input_of_bytes(*bytes, 12), input);
  }
}

TEST(ByteInput, OnlyLatticesCanBeEncoded) {
  EXPECT_EQ(bytes_of_input({{{0, 0, 0}, {1, -1, 1}}}), (ByteString{0x00, 1, 1, 1, 0, 2, 0, 2, 0}));
  EXPECT_FALSE(bytes_of_input({{{0.1, 0, 0}}}).has_value());
  EXPECT_FALSE(bytes_of_input({{{128, 0, 0}}}).has_value());
  EXPECT_FALSE(bytes_of_input({{{1, 0, 0}, {0x1p-300, 0, 0}}}).has_value());
}

}  // namespace
}  // namespace flowcert::fuzz::byte_input_test
