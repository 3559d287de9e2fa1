#pragma once

#include <cstddef>

namespace tripus::bench {

/// For each of `blocks` blocks of 8 tetrahedra: six sinh, six cosh, six atan2 and a square root a
/// lane. lengths [blocks][6][8] -> out [blocks][6][8].
using Transcendentals = void (*)(std::size_t blocks, const double* lengths, double* out);

void portable_transcendentals(std::size_t blocks, const double* lengths, double* out);
void avx2_transcendentals(std::size_t blocks, const double* lengths, double* out);
void avx512_transcendentals(std::size_t blocks, const double* lengths, double* out);

/// The same by the C library's vector functions (libmvec), for the widest instruction set that the
/// compiler was allowed: 8 lanes if `wide`, else 2.
void libmvec_transcendentals(std::size_t blocks, const double* lengths, double* out);
void libmvec_wide_transcendentals(std::size_t blocks, const double* lengths, double* out);

}  // namespace tripus::bench
