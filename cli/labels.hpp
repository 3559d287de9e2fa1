#pragma once

#include <string>
#include <utility>

namespace tripus::cli {

/// An INPUT and the labels behind it on a line of a batch: "eLAkbbcddpuchf 0=7,1=2" becomes
/// {"eLAkbbcddpuchf", "0=7,1=2"}; without labels, or if there is a file of the whole name, the
/// second is empty.
std::pair<std::string, std::string> split_labels(const std::string& input);

}  // namespace tripus::cli
