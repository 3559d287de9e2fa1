#pragma once

#include <optional>
#include <span>
#include <string>

#include "manifold/subject.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::cli {

/// Text from outside made fit for a terminal: control characters as \xHH, all else as it is.
std::string printable(std::string_view text);

/// The signature for people: of a large triangulation its beginning and length, --json has it
/// whole.
std::string signature_text(const std::optional<std::string>& isosig);

/// "1 edge class", "2 edge classes".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Why `solve` would refuse it with these cone angles; empty if it would not.
std::string objection_to(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles = {});

/// One line for people: "2 tetrahedra, 1 edge class (valence 12), orientable, boundary of genus 2".
std::string one_line(const topology::Triangulation& triangulation);

/// A list of numbers for people, shortened in the middle of the long ones.
std::string shortened(const std::vector<std::string>& items, std::size_t limit = 12);

}  // namespace tripus::cli
