// What GMP's longlong.h has in assembler for processors: limbs have 32 bits, and WebAssembly has integers of 64. The
// compiler reads this before every file of GMP, whose own definitions then stand back.
#pragma once

#define umul_ppmm(high, low, left, right)                                                   \
  do {                                                                                      \
    const unsigned long long product_ = (unsigned long long)(left) * (unsigned int)(right); \
    (low) = (unsigned int)product_;                                                         \
    (high) = (unsigned int)(product_ >> 32);                                                \
  } while (0)

#define udiv_qrnnd(quotient, remainder, high, low, divisor)                                      \
  do {                                                                                           \
    const unsigned long long dividend_ = (unsigned long long)(high) << 32 | (unsigned int)(low); \
    const unsigned int divisor_ = (divisor);                                                     \
    (quotient) = (unsigned int)(dividend_ / divisor_);                                           \
    (remainder) = (unsigned int)(dividend_ % divisor_);                                          \
  } while (0)

#define count_leading_zeros(count, limb) ((count) = __builtin_clz(limb))
#define count_trailing_zeros(count, limb) ((count) = __builtin_ctz(limb))
