// Rational and double coordinates as integers over one common denominator, for polynomials that are
// homogeneous in them.
//
// Guarantees: exact. A sum or product of rationals needs a greatest common divisor; on the long numbers of a cascade
// that is nearly all of their cost. Integers need none.
#pragma once

#include <gmpxx.h>

#include <cmath>

#include "flow/kernels/layer.h"
#include "geometry/contract.h"

namespace flowcert::flow {

class CommonDenominator {
 public:
  void include(const mpq_class& value) {
    const mpz_class& d = value.get_den();
    if (d != denominator_) mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), d.get_mpz_t());
  }
  void include(double value) {
    if (value == 0) return;
    int exponent = 0;
    std::frexp(value, &exponent);
    // A double is an integer of 53 bits times 2^(exponent - 53).
    if (exponent >= kBits) return;
    const auto shift = static_cast<mp_bitcnt_t>(kBits - exponent);
    const mp_bitcnt_t present = mpz_scan1(denominator_.get_mpz_t(), 0);
    if (present < shift) denominator_ <<= shift - present;
  }

  [[nodiscard]] const mpz_class& value() const { return denominator_; }

  // The value times the denominator; it must have been included.
  [[nodiscard]] mpz_class scaled(const mpq_class& value) const {
    FLOWCERT_REQUIRES(mpz_divisible_p(denominator_.get_mpz_t(), value.get_den_mpz_t()) != 0);
    mpz_class factor;
    mpz_divexact(factor.get_mpz_t(), denominator_.get_mpz_t(), value.get_den_mpz_t());
    return mpz_class(value.get_num() * factor);
  }
  [[nodiscard]] mpz_class scaled(double value) const {
    int exponent = 0;
    // GMP takes the double itself: 53 bits are more than a long has on some systems.
    mpz_class product(std::ldexp(std::frexp(value, &exponent), kBits));
    product *= denominator_;
    if (exponent >= kBits) return mpz_class(product << static_cast<mp_bitcnt_t>(exponent - kBits));
    return mpz_class(product >> static_cast<mp_bitcnt_t>(kBits - exponent));
  }

 private:
  static constexpr int kBits = 53;
  mpz_class denominator_ = 1;
};

}  // namespace flowcert::flow
