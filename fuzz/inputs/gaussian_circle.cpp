// Each prime factor splits into two conjugate Gaussian primes. A point is a product of them, times a power of i.
#include "fuzz/inputs/gaussian_circle.h"

#include <algorithm>
#include <utility>

namespace flowcert::fuzz {
namespace {

constexpr std::array<Gaussian, kNormPrimes> kPrimes{{{2, 1}, {3, 2}, {4, 1}, {5, 2}, {6, 1}, {5, 4}, {7, 2}, {6, 5}}};

bool is_upper(const Gaussian& z) { return z[1] > 0 || (z[1] == 0 && z[0] > 0); }

// Orders points of one circle about the origin by angle.
bool comes_before(const Gaussian& a, const Gaussian& b) {
  if (is_upper(a) != is_upper(b)) {
    return is_upper(a);
  }
  return is_upper(a) ? a[0] > b[0] : a[0] < b[0];
}

}  // namespace

Gaussian product(const Gaussian& a, const Gaussian& b) {
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

Gaussian power(const Gaussian& base, int exponent) {
  Gaussian result{1, 0};
  for (int k = 0; k < exponent; ++k) {
    result = product(result, base);
  }
  return result;
}

std::vector<Gaussian> integer_circle(const PrimeExponents& norm) {
  std::vector<Gaussian> circle{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (std::size_t k = 0; k < kPrimes.size(); ++k) {
    const Gaussian& prime = kPrimes[k];
    const Gaussian conjugate{prime[0], -prime[1]};
    std::vector<Gaussian> multiples;
    for (int split = 0; split <= norm[k]; ++split) {
      const Gaussian factor = product(power(prime, split), power(conjugate, norm[k] - split));
      for (const Gaussian& point : circle) {
        multiples.push_back(product(point, factor));
      }
    }
    circle = std::move(multiples);
  }
  std::sort(circle.begin(), circle.end(), comes_before);
  return circle;
}

}  // namespace flowcert::fuzz
