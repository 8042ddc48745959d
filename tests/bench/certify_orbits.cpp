// certify_orbits INPUT COUNT SEED: draws orbits of unstable manifolds at random, and compares those of the
// fast implementation with the oracle's, segment by segment, exactly.
//
// COUNT pairs of an index-2 point and a side are drawn, with repetition. The fast side computes all orbits
// first, by the cascade kernel and with sharing; the oracle computes each of those that are drawn from its
// definition, by scans over all points. Each reads the file with its own reader; only the contact set of the
// index-2 point goes from one to the other, and the oracle certifies it before it uses it.
//
// Exit status: 0 all equal; 1 a difference, which is printed; 2 unusable input or usage.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/program/read_points.h"

namespace {

constexpr int kDifferent = 1;
constexpr int kUnusable = 2;

std::string with_commas(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t place = digits.size(); place > 3; place -= 3) {
    digits.insert(place - 3, 1, ',');
  }
  return digits;
}

class Clock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What both sides say of an orbit, as text: rationals are canonical, so that equal orbits are equal texts.
struct OrbitText {
  std::vector<std::string> segments;
  std::string limit;
};

std::string text(const std::array<oracle::Rational, 3>& x) {
  return std::string("(") + x[0].str() + ", " + x[1].str() + ", " + x[2].str() + ")";
}

template <typename Ids>
std::string text_of_ids(const Ids& ids) {
  std::string result = "{";
  for (const auto id : ids) {
    result += ' ';
    result += std::to_string(id);
  }
  return result + " }";
}

template <typename Segment>
std::string text(const std::string& type, const Segment& segment) {
  return type + " from " + text(segment.start) + " driver " + text(segment.driver) + " end " +
         (segment.end ? text(*segment.end) : "infinity") + " contact " + text_of_ids(segment.start_contact) +
         text_of_ids(segment.crossed_contact) + text_of_ids(segment.end_contact);
}

OrbitText describe(const flowcert::Orbit& orbit) {
  OrbitText result;
  for (const flowcert::FlowSegment& segment : orbit.segments) {
    result.segments.push_back(text(flowcert::type_text(segment.type), segment));
  }
  result.limit = "infinity";
  if (orbit.limit) {
    result.limit = "index " + std::to_string(orbit.limit->index.face_dimension) + "-" +
                   std::to_string(orbit.limit->index.hull_dimension) + " at " + text(orbit.limit->position) +
                   " contact " + text_of_ids(orbit.limit->contact);
  }
  return result;
}

OrbitText describe(const oracle::PointSet& set, const oracle::Orbit& orbit) {
  OrbitText result;
  for (const oracle::FlowSegment& segment : orbit.segments) {
    result.segments.push_back(text(oracle::segment_type(set, segment), segment));
  }
  result.limit = "infinity";
  if (orbit.limit) {
    result.limit = "index " + std::to_string(orbit.limit->face_dimension) + "-" +
                   std::to_string(orbit.limit->hull_dimension) + " at " + text(orbit.limit->center) + " contact " +
                   text_of_ids(orbit.limit->contact);
  }
  return result;
}

// The first difference, with the lines of both orbits. Empty if there is none.
std::string difference(const OrbitText& fast, const OrbitText& reference) {
  const auto both = [](const std::string& where, const std::string& a, const std::string& b) {
    return where + "\n  fast:   " + a + "\n  oracle: " + b + "\n";
  };
  const std::size_t common = std::min(fast.segments.size(), reference.segments.size());
  for (std::size_t k = 0; k < common; ++k) {
    if (fast.segments[k] != reference.segments[k]) {
      return both("segment " + std::to_string(k + 1), fast.segments[k], reference.segments[k]);
    }
  }
  if (fast.segments.size() != reference.segments.size()) {
    return both("number of segments", std::to_string(fast.segments.size()), std::to_string(reference.segments.size()));
  }
  return fast.limit == reference.limit ? "" : both("limit", fast.limit, reference.limit);
}

// The bits of the longest numerator or denominator of a coordinate.
std::size_t bits(const oracle::Orbit& orbit) {
  std::size_t most = 0;
  for (const oracle::FlowSegment& segment : orbit.segments) {
    for (const oracle::Rational& x : segment.start) {
      most = std::max(
          {most, mpz_sizeinbase(mpq_numref(x.backend().data()), 2), mpz_sizeinbase(mpq_denref(x.backend().data()), 2)});
    }
  }
  return most;
}

// The index-2 point with this contact set, from the oracle's own geometry.
oracle::StationaryPoint certified_saddle(const oracle::PointSet& set, std::span<const flowcert::PointId> contact) {
  oracle::StationaryPoint saddle;
  saddle.contact.assign(contact.begin(), contact.end());
  std::vector<oracle::Point> points;
  for (const std::size_t name : saddle.contact) {
    const auto position = std::lower_bound(set.names.begin(), set.names.end(), name);
    points.push_back(set.points.at(static_cast<std::size_t>(position - set.names.begin())));
  }
  saddle.center = oracle::circumcentre(oracle::spanning_subset(points)).value().center;
  saddle.squared_distance = oracle::squared_distance(saddle.center, points.front());
  saddle.face_dimension = saddle.hull_dimension = 2;
  if (const auto fault = oracle::certify(set, saddle)) {
    throw std::runtime_error("no index-2 point: " + fault->explanation);
  }
  return saddle;
}

struct Tally {
  std::size_t segments = 0;
  std::size_t longest = 0;
  std::size_t bits = 0;
};

// Draws the orbits and compares them, up to the first difference. run() returns that one, or nothing.
class Certification {
 public:
  Certification(const oracle::PointSet& set, const flowcert::StationaryPoints& stationary,
                const flowcert::UnstableManifolds& manifolds)
      : set_(set), stationary_(stationary), manifolds_(manifolds) {}

  [[nodiscard]] std::string run(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::string found;
    for (std::size_t done = 0; done < count && found.empty(); ++done) {
      show_progress(done, count);
      // One number chooses point and side, so that all orbits are equally likely, but for less than 2^-40 of it.
      const std::size_t orbit = random() % (2 * manifolds_.size());
      found = compare(orbit / 2, orbit % 2);
    }
    if (is_terminal_) {
      std::cerr << '\n';
    }
    return found;
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  std::string compare(std::size_t i, std::size_t side) {
    const oracle::StationaryPoint saddle = certified_saddle(set_, stationary_.contact(manifolds_.saddle(i)));
    const oracle::Orbit reference = oracle::unstable_orbit(set_, saddle, static_cast<int>(side));
    tally_.segments += reference.segments.size();
    tally_.longest = std::max(tally_.longest, reference.segments.size());
    tally_.bits = std::max(tally_.bits, bits(reference));
    const std::string where = "the index-2 point " + text_of_ids(saddle.contact) + ", side " + std::to_string(side);
    const std::string found = difference(describe(manifolds_.orbit(i, side)), describe(set_, reference));
    if (!found.empty()) {
      return where + ", " + found;
    }
    // limit() is known without the orbit.
    const std::optional<std::size_t> limit = manifolds_.limit(i, side);
    const bool same = limit.has_value() == reference.limit.has_value() &&
                      (!limit || std::ranges::equal(stationary_.contact(*limit), reference.limit->contact));
    return same ? "" : where + ", limit() is another than the orbit's\n";
  }

  void show_progress(std::size_t done, std::size_t count) const {
    if (is_terminal_) {
      std::cerr << '\r' << done << " of " << count << " orbits, " << std::lround(clock_.seconds()) << " s"
                << std::flush;
    }
  }

  const oracle::PointSet& set_;
  const flowcert::StationaryPoints& stationary_;
  const flowcert::UnstableManifolds& manifolds_;
  Tally tally_;
  Clock clock_;
  bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
};

int run(const std::string& input, std::size_t count, std::uint64_t seed) {
  const Clock clock;
  const std::vector<flowcert::Point> rows = flowcert::read_points(input).rows;
  const flowcert::FlowComplex complex(rows);
  const flowcert::UnstableManifolds& manifolds = complex.unstable();
  if (manifolds.size() == 0) {
    throw std::runtime_error(input + ": there is no critical point of index 2");
  }
  const oracle::fast::PointSet set(oracle::read_point_file(input));
  Certification certification(set, complex.stationary(), manifolds);
  const std::string found = certification.run(count, seed);
  if (!found.empty()) {
    std::cout << "DIFFERENT: " << found;
    return kDifferent;
  }
  const Tally& tally = certification.tally();
  std::cout << with_commas(count) << " of " << with_commas(count) << " U2 orbits of " << with_commas(set.points.size())
            << " points certified by the oracle, exactly: " << with_commas(tally.segments) << " segments, longest "
            << with_commas(tally.longest) << ", largest coordinate " << with_commas(tally.bits) << " bits ("
            << std::lround(clock.seconds()) << " s)\n";
  return 0;
}

std::uint64_t natural(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw std::runtime_error(std::string("'") + std::string(word) + "' is no natural number");
  }
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) {
      throw std::runtime_error("usage: certify_orbits INPUT COUNT SEED");
    }
    return run(argv[1], natural(argv[2]), natural(argv[3]));
  } catch (const std::exception& error) {
    std::cerr << "certify_orbits: " << error.what() << '\n';
    return kUnusable;
  }
}
