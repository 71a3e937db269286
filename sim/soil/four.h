// Four numbers at once, for laws that hold for one patch of soil as for four. A law that is written
// for a type Real takes double and Four alike, and gives each of the four the same bits as double.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace dockyard {

/// Two pairs: every x86-64 processor has instructions for a pair.
struct Four {
  using Two = double __attribute__((vector_size(16)));
  Two low{0.0, 0.0}, high{0.0, 0.0};

  Four() = default;
  Four(double all) : low{all, all}, high{all, all} {}  // NOLINT: a number stands for four alike
  Four(Two low_pair, Two high_pair) : low(low_pair), high(high_pair) {}
  Four(double a, double b, double c, double d) : low{a, b}, high{c, d} {}

  double operator[](int i) const { return i < 2 ? low[i] : high[i - 2]; }
};

/// What a comparison of Fours gives: all bits of a place, or none.
struct FourMask {
  using Two = std::int64_t __attribute__((vector_size(16)));
  Two low, high;
};

inline Four operator+(Four a, Four b) { return {a.low + b.low, a.high + b.high}; }
inline Four operator-(Four a, Four b) { return {a.low - b.low, a.high - b.high}; }
inline Four operator*(Four a, Four b) { return {a.low * b.low, a.high * b.high}; }
inline Four operator/(Four a, Four b) { return {a.low / b.low, a.high / b.high}; }
inline Four operator-(Four a) { return {-a.low, -a.high}; }
inline Four& operator+=(Four& a, Four b) { return a = a + b; }
inline Four& operator-=(Four& a, Four b) { return a = a - b; }

inline FourMask operator<(Four a, Four b) { return {a.low < b.low, a.high < b.high}; }
inline FourMask operator<=(Four a, Four b) { return {a.low <= b.low, a.high <= b.high}; }
inline FourMask operator>(Four a, Four b) { return b < a; }
inline FourMask operator>=(Four a, Four b) { return b <= a; }
inline FourMask operator&(FourMask a, FourMask b) { return {a.low & b.low, a.high & b.high}; }
inline FourMask operator|(FourMask a, FourMask b) { return {a.low | b.low, a.high | b.high}; }

/// a where the mask is set, else b.
inline Four Select(FourMask mask, Four a, Four b) {
  return {mask.low ? a.low : b.low, mask.high ? a.high : b.high};
}
inline double Select(bool first, double a, double b) { return first ? a : b; }

/// The mask's places as bits, the first the lowest.
inline unsigned Bits(FourMask mask) {
#if defined(__SSE2__)
  return __builtin_ia32_movmskpd(reinterpret_cast<Four::Two>(mask.low)) |
         __builtin_ia32_movmskpd(reinterpret_cast<Four::Two>(mask.high)) << 2;
#else
  return (mask.low[0] & 1) | (mask.low[1] & 2) | (mask.high[0] & 4) | (mask.high[1] & 8);
#endif
}
inline unsigned Bits(bool value) { return value ? 1 : 0; }

template <typename Mask>
bool Any(Mask mask) {
  return Bits(mask) != 0;
}

/// The numbers from here on.
template <typename Real>
Real Load(const double* first);
template <>
inline double Load<double>(const double* first) {
  return *first;
}
template <>
inline Four Load<Four>(const double* first) {
  Four four;
  std::memcpy(&four.low, first, sizeof four.low);
  std::memcpy(&four.high, first + 2, sizeof four.high);
  return four;
}

/// Calls visit.operator()<Real>(i) for all of 0 <= i < count, by fours as far as they go: Real is
/// Four for i to i + 3, or double.
template <typename Visit>
void ForFours(int count, const Visit& visit) {
  int i = 0;
  for (; i + 4 <= count; i += 4) visit.template operator()<Four>(i);
  for (; i < count; ++i) visit.template operator()<double>(i);
}
/// of(0) to of(3), or of(0) alone.
template <typename Real, typename Of>
Real Gather(const Of& of) {
  if constexpr (std::is_same_v<Real, Four>) {
    return Four(of(0), of(1), of(2), of(3));
  } else {
    return of(0);
  }
}
inline double Place(Four four, int i) { return four[i]; }
inline double Place(double one, int) { return one; }
/// i and the numbers after it.
template <typename Real>
Real From(int i);
template <>
inline double From<double>(int i) {
  return i;
}
template <>
inline Four From<Four>(int i) {
  return Four(0.0, 1.0, 2.0, 3.0) + static_cast<double>(i);
}

inline Four Min(Four a, Four b) { return Select(a < b, a, b); }
inline Four Max(Four a, Four b) { return Select(a > b, a, b); }
inline double Min(double a, double b) { return a < b ? a : b; }
inline double Max(double a, double b) { return a > b ? a : b; }

inline Four::Two Sqrt(Four::Two a) {
  const Eigen::Array2d root = Eigen::Array2d(a[0], a[1]).sqrt();  // by one instruction
  return Four::Two{root[0], root[1]};
}
inline Four Sqrt(Four a) { return {Sqrt(a.low), Sqrt(a.high)}; }
inline double Sqrt(double a) { return std::sqrt(a); }

inline Four Abs(Four a) { return Max(a, -a); }
inline double Abs(double a) { return std::fabs(a); }

/// The largest of the four.
inline double Largest(Four a) { return Max(Max(a[0], a[1]), Max(a[2], a[3])); }
inline double Largest(double a) { return a; }
/// Their sum.
inline double Sum(Four a) { return (a[0] + a[1]) + (a[2] + a[3]); }
inline double Sum(double a) { return a; }

/// base^exponent, to 2e-12 of it, for 1e-30 <= base <= 1e30 and 0 < exponent <= 2.5; no other base
/// is allowed. By polynomials of its own, not the C library's: the same bits with every library.
Four Power(Four base, double exponent);
double Power(double base, double exponent);

namespace power {

/// ln m = 2 artanh t, t = (m - 1) / (m + 1), for m from sqrt(1/2) to sqrt(2), so |t| < 0.1716: what
/// follows t^13 is below 5e-13.
inline Four::Two LogOfMantissa(Four::Two m) {
  const Four::Two t = (m - 1.0) / (m + 1.0), s = t * t;
  return t * (2.0 +
              s * (2.0 / 3.0 +
                   s * (2.0 / 5.0 +
                        s * (2.0 / 7.0 + s * (2.0 / 9.0 + s * (2.0 / 11.0 + s * (2.0 / 13.0)))))));
}

/// e^y for |y| < ln(2) / 2: what follows y^10 is below 3e-13.
inline Four::Two ExpNearZero(Four::Two y) {
  return 1.0 +
         y * (1.0 +
              y * (1.0 / 2.0 +
                   y * (1.0 / 6.0 +
                        y * (1.0 / 24.0 +
                             y * (1.0 / 120.0 +
                                  y * (1.0 / 720.0 +
                                       y * (1.0 / 5040.0 + y * (1.0 / 40320.0 +
                                                                y * (1.0 / 362880.0 +
                                                                     y * (1.0 / 3628800.0))))))))));
}

inline Four::Two PowerOfTwo(Four::Two base, double exponent) {
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  constexpr std::uint64_t kSqrtHalf = 0x3FE6A09E667F3BCD;  // the bits of sqrt(1/2)
  constexpr std::uint64_t kBias = 1023, kMantissa = (std::uint64_t{1} << 52) - 1;
  constexpr double kTwo52 = 4503599627370496.0;
  // base = 2^e m, with m from sqrt(1/2) on.
  const Bits shifted = reinterpret_cast<Bits>(base) - kSqrtHalf;
  const Bits biased = (shifted + (kBias << 52)) >> 52;
  const Bits two52 = Bits{} + reinterpret_cast<Bits>(Four::Two{kTwo52, kTwo52});
  const Four::Two e =
      reinterpret_cast<Four::Two>(biased | two52) - (kTwo52 + static_cast<double>(kBias));
  const Four::Two m = reinterpret_cast<Four::Two>((shifted & kMantissa) + kSqrtHalf);
  // The result is 2^p = 2^k e^((p - k) ln 2), k whole: rounded by a number whose last bit is 1.
  constexpr double kLog2E = 1.4426950408889634, kLn2 = 0.6931471805599453;
  constexpr double kRound = 1.5 * kTwo52;
  const Four::Two p = exponent * (e + kLog2E * LogOfMantissa(m));
  const Four::Two whole = p + kRound;
  const Four::Two part = ExpNearZero((p - (whole - kRound)) * kLn2);
  return reinterpret_cast<Four::Two>(reinterpret_cast<Bits>(part) +
                                     (reinterpret_cast<Bits>(whole) << 52));
}

}  // namespace power

inline Four Power(Four base, double exponent) {
  return {power::PowerOfTwo(base.low, exponent), power::PowerOfTwo(base.high, exponent)};
}
inline double Power(double base, double exponent) {
  return power::PowerOfTwo(Four::Two{base, 1.0}, exponent)[0];
}

}  // namespace dockyard
