// The points of a file, the vectors between them in each number type, and spheres through them.
// A row is known by its number, from 0. Rows of equal coordinates are one point, whose id is the first of them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <vector>

#include "numbers.h"

using Id = std::uint32_t;
constexpr Id kNone = 0xffffffff;
using Row = std::array<double, 3>;

inline std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) cannot_decide(path + ": cannot be read");
  return bytes;
}

// Reads [-]digits[.digits][e[+-]digits], with a digit beside the point, as the nearest double.
inline bool read_decimal(const char*& at, double& x) {
  const char *const begin = at, *const end = at + std::strspn(at, "0123456789.e+-");  // nothing else that strtod reads
  x = std::strtod(begin, const_cast<char**>(&at));
  return begin != end && *begin != '+' && at == end;
}

class Points {
 public:
  // Reads .xyz, three decimals a row, or .f64, three doubles a row, little-endian.
  explicit Points(const std::string& path) : Points(read(path)) {}
  explicit Points(const std::vector<Row>& rows) {  // finite ones
    find_ids(rows);
    find_grid(rows);
  }

  std::size_t row_count() const { return id_of_row_.size(); }
  std::size_t point_count() const { return point_count_; }
  Id id_of_row(Id row) const { return id_of_row_[row]; }
  bool is_id(std::uint64_t number) const { return number < id_of_row_.size() && id_of_row_[number] == number; }

  // All coordinates are integers times 2^grid_exponent(), and these are the integers.
  int grid_exponent() const { return grid_exponent_; }
  int grid_bits() const { return grid_bits_; }  // their number
  const mpz_class& on_grid(Id p, std::size_t axis) const { return on_grid_[p][axis]; }

  // The vector from p to q: in units of the grid for integers, scaled for Filtered.
  template <class N>
  Vector<N> vector(Id p, Id q) const {
    return {difference(N{}, p, q, 0), difference(N{}, p, q, 1), difference(N{}, p, q, 2)};
  }
  // The sign of a polynomial, a function of the number type alone. 128 bits hold what it computes if coordinates on the
  // grid are below 2^bits: a triangle's sphere is below 2^(6 bits + 13), two radii are below 2^(14 bits + 31).
  template <class Polynomial>
  int sign(const Polynomial& polynomial, int bits = 18) const {
    const Filtered filtered = polynomial.template operator()<Filtered>();
    if (filtered.has_certain_sign()) return sign_of(filtered);
    if (grid_bits_ <= bits) return sign_of(polynomial.template operator()<Integer128>());
    return sign_of(polynomial.template operator()<BigInteger>());
  }

 private:
  static std::vector<Row> read(const std::string& path) {
    const std::string bytes = bytes_of_file(path);
    std::vector<Row> rows;
    const auto fail = [&](std::size_t row, const char* why) { cannot_decide(path + ":" + std::to_string(row) + why); };
    if (path.ends_with(".xyz") && !bytes.empty()) {
      const char *at = bytes.c_str(), *const end = at + bytes.size();
      while (at != end) {
        if (!read_row(at, end, rows.emplace_back())) fail(rows.size(), ": not three decimals with blanks between");
      }
    } else if (path.ends_with(".f64") && bytes.size() % sizeof(Row) == 0) {
      static_assert(std::endian::native == std::endian::little && sizeof(Row) == 24);
      rows.resize(bytes.size() / sizeof(Row));
      std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(rows.data()));
    } else {
      cannot_decide(path + ": neither .xyz with points nor .f64 with 24 bytes a row");
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      for (double& x : rows[k]) {
        if (!std::isfinite(x += 0.0)) fail(k + 1, ": a coordinate is not finite");  // and -0 is 0
      }
    }
    if (rows.size() >= kNone) cannot_decide(path + ": too many rows");
    return rows;
  }
  static bool read_row(const char*& at, const char* end, Row& row) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t blanks = k == 0 ? 0 : std::strspn(at, " \t");
      if ((k > 0 && blanks == 0) || !read_decimal(at += blanks, row[k])) return false;
    }
    if (*at == '\r' && at[1] == '\n') ++at;
    return at == end || *at++ == '\n';
  }

  void find_ids(const std::vector<Row>& rows) {
    id_of_row_.resize(rows.size());
    std::vector<Id> order(rows.size());
    std::iota(order.begin(), order.end(), Id{0});
    std::stable_sort(order.begin(), order.end(), [&](Id a, Id b) { return rows[a] < rows[b]; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool is_new = k == 0 || rows[order[k - 1]] != rows[order[k]];
      id_of_row_[order[k]] = is_new ? order[k] : id_of_row_[order[k - 1]];
      if (is_new) ++point_count_;
    }
  }
  void find_grid(const std::vector<Row>& rows) {
    int low = 2000, high = -2000;  // all coordinates are multiples of 2^low, and below 2^high
    for (const Row& row : rows) {
      for (const double x : row) {
        if (x != 0) low = std::min(low, lowest_bit(x)), high = std::max(high, std::ilogb(x) + 1);
      }
    }
    grid_exponent_ = low;
    grid_bits_ = std::max(0, high - low);
    scaled_.resize(rows.size());
    on_grid_.resize(rows.size());
    for (std::size_t p = 0; p < rows.size(); ++p) {
      for (std::size_t k = 0; k < 3; ++k) {
        scaled_[p][k] = std::ldexp(rows[p][k], -high);
        const int zeros = rows[p][k] == 0 ? 0 : lowest_bit(rows[p][k]) - low;
        on_grid_[p][k] = mpz_class(std::ldexp(rows[p][k], -low - zeros)) << static_cast<mp_bitcnt_t>(zeros);
      }
    }
  }
  static int lowest_bit(double x) {  // its exponent
    const double mantissa = std::ldexp(std::fabs(x), 52 - std::ilogb(x));
    return std::ilogb(x) - 52 + std::countr_zero(static_cast<std::uint64_t>(mantissa));
  }
  Filtered difference(Filtered, Id p, Id q, std::size_t k) const { return scaled_[q][k] - scaled_[p][k]; }
  Integer128 difference(Integer128, Id p, Id q, std::size_t k) const {  // exact, because of so few bits
    return static_cast<Integer128>((scaled_[q][k] - scaled_[p][k]) * static_cast<double>(1 << grid_bits_));
  }
  BigInteger difference(BigInteger, Id p, Id q, std::size_t k) const { return {on_grid_[q][k] - on_grid_[p][k]}; }

  std::vector<Id> id_of_row_;
  std::size_t point_count_ = 0;
  int grid_exponent_ = 0, grid_bits_ = 0;
  std::vector<Row> scaled_;  // by a power of two, to less than 1
  std::vector<std::array<mpz_class, 3>> on_grid_;
};

using Simplex = std::array<Id, 4>;  // one to four ids, then kNone

// The circumcentre in the affine hull of the simplex is v[0] + numerator / (2 denominator): its product with each edge
// at v[0] is half that edge's square. The denominator is the volume for four vertices, and positive for fewer.
template <class N>
struct Circumcenter {
  Vector<N> numerator;
  N denominator;
};
template <class N>
Circumcenter<N> circumcenter(const Points& points, const Simplex& v) {
  if (v[1] == kNone) return {{}, N{1}};
  const auto a = points.vector<N>(v[0], v[1]);
  if (v[2] == kNone) return {a, N{1}};
  const auto b = points.vector<N>(v[0], v[2]), ab = cross(a, b);
  if (v[3] == kNone) return {cross(b, ab) * dot(a, a) + cross(ab, a) * dot(b, b), dot(ab, ab)};
  const auto c = points.vector<N>(v[0], v[3]);
  return {cross(b, c) * dot(a, a) + cross(c, a) * dot(b, b) + ab * dot(c, c), dot(ab, c)};
}

// Negative, zero or positive as x is inside, on or outside. The denominator must be positive, as it is after T1.
inline int side_of_sphere(const Points& points, const Simplex& v, Id x) {
  return points.sign([&]<class N>() {
    const auto [numerator, denominator] = circumcenter<N>(points, v);
    const auto y = points.vector<N>(v[0], x);
    return denominator * dot(y, y) - dot(numerator, y);
  });
}
