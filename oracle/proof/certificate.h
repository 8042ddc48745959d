// The cells that a certificate tells, and which of their facets are paired; T2.
// In dimension d a cell has vertices at the places 0 to d. Facet i is without the vertex at place i, which is opposite
// to it. A facet has the number 4 * (number of the cell) + i.
#pragma once

#include <random>
#include <utility>

#include "points.h"

using Facet = std::uint32_t;
constexpr Facet kHull = kNone, kOpen = kNone - 1;  // instead of a mate: not paired; not known yet

struct Triangulation {
  int dimension = -1;
  std::vector<Simplex> cells;
  std::vector<std::array<Facet, 4>> mates;  // by cell and place: the facet that this one is paired with, or kHull

  Facet& mate(Facet facet) { return mates[facet / 4][facet % 4]; }
  Facet mate(Facet facet) const { return mates[facet / 4][facet % 4]; }
  Id opposite(Facet facet) const { return cells[facet / 4][facet % 4]; }
  std::uint32_t places() const { return static_cast<std::uint32_t>(dimension + 1); }

  // In the order of places. The cell induces this orientation on its facet if the opposite vertex is at an even place,
  // and the other one if it is at an odd place. (With T1, that of FC-CERT-01.)
  Simplex vertices(Facet facet) const {
    const Simplex& v = cells[facet / 4];
    const Facet i = facet % 4;
    return {v[i > 0 ? 0 : 1], v[i > 1 ? 1 : 2], v[i > 2 ? 2 : 3], kNone};
  }
};

// Up to three ids in ascending order, then kNone, and whether it takes an odd permutation to get there.
struct SortedIds {
  Simplex ids;
  bool is_odd;
  explicit SortedIds(const Simplex& v) : is_odd((v[0] > v[1]) != ((v[0] > v[2]) != (v[1] > v[2]))) {
    const Id low = std::min(v[0], v[1]), high = std::max(v[0], v[1]);
    ids = {std::min(low, v[2]), std::max(low, std::min(high, v[2])), std::max(high, v[2]), kNone};
  }
};

class CertificateReader {
 public:
  CertificateReader(std::string name, std::string bytes, const Points& points)
      : name_(std::move(name)), bytes_(std::move(bytes)), points_(points) {}

  Triangulation read() {
    read_header();
    if (count_ > 0) read_cells();
    if (at_ != bytes_.size() || t_.cells.size() != count_) fail("it has not the cells that it says");
    return std::move(t_);
  }
  bool has_hash() const { return has_hash_; }

 private:
  [[noreturn]] void fail(const std::string& why) const { cannot_decide(name_ + ": cannot be decoded: " + why); }

  bool take(const std::string& text) {
    const bool is_there = bytes_.compare(at_, text.size(), text) == 0;
    if (is_there) at_ += text.size();
    return is_there;
  }
  void read_header() {
    if (!take("flowcert-certificate 1\npoints ")) fail("it does not begin like a certificate");
    if (!take(std::to_string(points_.row_count()) + "\n")) fail("it is not of these points");
    has_hash_ = take("sha256 ");
    const std::size_t end = has_hash_ ? bytes_.find_first_not_of("0123456789abcdef", at_) : at_;
    if (has_hash_ && end != at_ + 64) fail("its hash");
    at_ = end;
    if (!take(has_hash_ ? "\ndimension " : "dimension ")) fail("no dimension");
    while (!take(std::to_string(t_.dimension) + "\ncells ")) {
      if (++t_.dimension > 3) fail("its dimension");
    }
    count_ = std::strtoull(bytes_.c_str() + at_, nullptr, 10);
    if (!take(std::to_string(count_) + "\n\n")) fail("its number of cells");
    if ((count_ == 0) != (t_.dimension < 1)) fail("there are cells if and only if the dimension is at least 1");
    if (count_ > bytes_.size() - at_ || count_ >= kOpen / 4) fail("it says too many cells");  // a byte each
  }

  // The cells are glued one by one, each to a facet of an earlier one.
  void read_cells() {
    t_.cells.reserve(count_);
    t_.mates.reserve(count_);
    slots_.assign(std::bit_ceil(4 * count_ + 4), kNone);  // there are at most 3 * count + 1 sets of vertices
    Simplex first{kNone, kNone, kNone, kNone};
    for (Facet i = 0; i < t_.places(); ++i) first[i] = id(number());
    enter(first, kNone);
    while (!open_.empty()) {
      const Facet facet = open_.back();
      open_.pop_back();
      if (t_.mate(facet) != kOpen) continue;
      const std::uint64_t code = number();
      if (code > 0 && t_.cells.size() == count_) fail("it has more cells than it says");
      if (code > 0) enter(cell_behind(facet, code - 1), facet);
      if (code == 0) t_.mate(facet) = kHull;
    }
  }
  std::uint64_t number() {  // 7 bits a byte, the low ones first
    std::uint64_t value = 0;
    for (int shift = 0; shift < 35 && at_ < bytes_.size(); shift += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes_[at_++]);
      value |= std::uint64_t{byte & 127U} << shift;
      if (byte < 128) return value;  // no point has a number beyond 2^33
    }
    fail("a number is cut short, or too long");
  }
  Id id(std::uint64_t number) const {
    if (!points_.is_id(number)) fail("there is no point " + std::to_string(number));
    return static_cast<Id>(number);
  }
  // The facet's cell with another vertex in the opposite one's place. Two places are swapped (in dimension 1, its only
  // two), so that its volume is positive if it lies behind the facet.
  Simplex cell_behind(Facet facet, std::uint64_t zigzag) const {
    Simplex cell = t_.cells[facet / 4];
    const Facet i = facet % 4;
    cell[i] = id(cell[i] + (zigzag >> 1 ^ -(zigzag & 1)));  // 0, -1, 1, -2, 2 ... are added
    std::swap(cell[t_.dimension > 1 && i == 0 ? 1 : 0], cell[t_.dimension > 1 && i < 2 ? 2 : 1]);
    return cell;
  }

  // Adds the cell, glued to the facet `front`. Its other facets are paired with those of the same vertices, or open.
  void enter(const Simplex& cell, Facet front) {
    const auto begin = static_cast<Facet>(4 * t_.cells.size());
    t_.cells.push_back(cell);
    t_.mates.push_back({kOpen, kOpen, kOpen, kOpen});
    if (front != kNone) pair(begin + (t_.dimension == 1 ? 1 - front % 4 : front % 4), front);
    for (Facet facet = begin; facet < begin + t_.places(); ++facet) {
      if (t_.mate(facet) != kOpen) continue;
      const Facet first = first_facet(facet);
      if (first == facet) open_.push_back(facet);
      if (first != facet) pair(facet, first);
    }
  }
  // T2. Paired facets have the same vertices, oppositely oriented, and no third facet has these.
  void pair(Facet facet, Facet other) {
    const auto reject_here = [facet](const char* why) { reject("T2 cell " + std::to_string(facet / 4) + why); };
    if (t_.mate(other) == kHull) reject_here(" is the second one at a facet that was left unpaired");
    if (t_.mate(other) != kOpen) reject_here(" is the third one at a facet");
    const bool is_odd = SortedIds(t_.vertices(facet)).is_odd != SortedIds(t_.vertices(other)).is_odd;
    if (is_odd == (facet % 2 != other % 2)) reject_here(" is on another one's side of a facet");
    t_.mate(facet) = other;
    t_.mate(other) = facet;
  }

  // The first facet with the vertices of this one, which may be this one; from a hash table that always has free slots.
  // There is chance in the hash, so that nobody can write a certificate whose facets all meet in one slot.
  Facet first_facet(Facet facet) {
    const Simplex ids = SortedIds(t_.vertices(facet)).ids;
    std::uint64_t hash = chance_;
    for (const Id id : ids) {
      hash = (hash ^ id) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    for (;; ++hash) {
      Facet& slot = slots_[hash & (slots_.size() - 1)];
      if (slot == kNone) slot = facet;
      if (slot == facet || SortedIds(t_.vertices(slot)).ids == ids) return slot;
    }
  }

  const std::string name_, bytes_;
  const Points& points_;
  std::size_t at_ = 0, count_ = 0;  // where in the bytes; of the cells
  bool has_hash_ = false;
  Triangulation t_;
  std::vector<Facet> open_, slots_;
  const std::uint64_t chance_ = std::uint64_t{std::random_device{}()} << 32 | std::random_device{}();
};
