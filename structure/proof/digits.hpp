#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "structure/proof/proof.hpp"

namespace tripus::structure {

/// A real number between two decimal numbers.
struct DecimalInterval {
  std::string lower, upper;
};

/// A metric to many proved digits.
struct Digits {
  bool proved = false;
  std::string reason;                ///< why not; empty if proved
  long bits = 0;                     ///< of the arithmetic
  std::vector<std::string> lengths;  ///< [E] decimal numbers, exact centres
  std::vector<std::string> radii;    ///< [E] upper bounds, below 10^-digits
  DecimalInterval volume;
  std::vector<std::array<DecimalInterval, 6>> dihedral_angles;  ///< [T]
};

/// Edge classes up to here are taken to many digits: Newton's method solves dense systems.
inline constexpr std::size_t kMostEdgesForDigits = 400;

/// Lengths, volume and dihedral angles to `digits` decimal digits after the point, from a proof in
/// doubles whose box and weights are used again: Newton's method in Arb finds the lengths, and the
/// same inequality bounds how far they are from the true ones.
///   digits  1 to 100,000
/// Throws InvalidInput if digits is out of range. Source: docs/theory.md (97).
Digits prove_digits(const topology::Triangulation& triangulation, const Proof& proof, int digits,
                    const Context& context = {});

/// `prove` near lengths: where it fails at these, again at the doubles next to what Newton's method
/// in Arb makes of them. For that, no finite vertices, nothing flat and at most kMostEdgesForDigits
/// edge classes. The proof's lengths are then not those given.
Proof prove_near(const topology::Triangulation& triangulation, std::span<const double> lengths,
                 const ProveOptions& options = {}, const Context& context = {});

}  // namespace tripus::structure
