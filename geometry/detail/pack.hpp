#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// A pack of W doubles (a GCC vector), and the few operations that the kernels need, so that one
/// template serves one tetrahedron (Real = double) and many (Real = Pack<W>). Every operation is
/// an IEEE operation on each lane and nothing is contracted, so all widths give the same bits.
///
/// The enclosing namespace is internal: each instruction set compiles its own copy.

// Packs are passed between functions of one translation unit only, so their calling convention,
// which depends on the instruction set, is nobody's business.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tripus::geometry {
namespace {

template <int W>
struct PackTypes {
  typedef double Real __attribute__((vector_size(W * 8)));
  typedef std::int64_t Bits __attribute__((vector_size(W * 8)));
};
template <int W>
using Pack = typename PackTypes<W>::Real;

/// The 64-bit pattern type that goes with a Real.
template <class Real>
struct BitsOf {
  typedef std::int64_t Type __attribute__((vector_size(sizeof(Real))));
};
template <>
struct BitsOf<double> {
  using Type = std::int64_t;
};

template <class To, class From>
inline To bits_as(From x) {
  return std::bit_cast<To>(x);
}

/// The constant c in every lane.
template <class Real>
inline Real broadcast(double c) {
  return Real{} + c;
}

template <class Real>
inline Real square_root(Real x) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return std::sqrt(x);
  } else {
    for (std::size_t i = 0; i < sizeof(Real) / sizeof(double); ++i) x[i] = std::sqrt(x[i]);
    return x;
  }
}

template <class Real>
inline Real maximum(Real x, Real y) {
  return x > y ? x : y;
}
template <class Real>
inline Real minimum(Real x, Real y) {
  return x > y ? y : x;
}
template <class Real>
inline Real magnitude(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  return bits_as<Real>(bits_as<Bits>(x) & (Bits{} + INT64_MAX));
}

}  // namespace
}  // namespace tripus::geometry
