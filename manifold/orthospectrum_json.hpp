#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "manifold/subject.hpp"
#include "orthospectrum/identities.hpp"
#include "orthospectrum/proved_lengths.hpp"
#include "orthospectrum/spectrum.hpp"

namespace tripus {

/// What `tripus orthospectrum` answers.
struct SpectrumAnswer {
  const Subject& subject;
  orthospectrum::Spectrum spectrum;
  orthospectrum::Grouping grouping;
  orthospectrum::Identities identities;
  /// Lengths of the edges of the canonical decomposition, if they were asked for and found.
  std::optional<std::vector<double>> canonical_edges;
  bool words = false;                                    ///< each arc by itself
  std::optional<orthospectrum::ProvedLengths> proved{};  ///< if it was asked for

  /// Indices of the arcs of a group.
  std::span<const std::size_t> members(const orthospectrum::ArcGroup& group) const;
  /// The edge classes among them, ascending.
  std::vector<std::uint32_t> edges_in(const orthospectrum::ArcGroup& group) const;
  /// How many edges of the canonical decomposition have this length.
  std::size_t canonical_edges_as_long(double length) const;
};

/// The JSON of `tripus orthospectrum`, with its keys in the documented order; no line end.
std::string spectrum_as_json(const SpectrumAnswer& answer);

}  // namespace tripus
