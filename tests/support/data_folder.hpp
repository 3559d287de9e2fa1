#pragma once

#include <string>

namespace tripus::testing {

/// The folder data/ of the sources. Compiled by itself, so that no other object file depends on
/// where the sources lie, and a compiler cache serves every checkout.
std::string data_folder();

}  // namespace tripus::testing
