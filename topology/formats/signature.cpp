#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

constexpr std::string_view kBehind = "_.(";

/// The signature alone, and what stands behind it.
std::string_view signature_of(std::string_view text) {
  return text.substr(0, text.find_first_of(kBehind));
}

/// "(1,2)(0,0)": the first that is not (0,0); nothing if all are. `text` is what stands behind.
std::string_view first_filling(std::string_view text) {
  std::size_t begin = text.find('(');
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find(')', begin), text.size() - 1);
    const std::string_view filling = text.substr(begin, end - begin + 1);
    if (filling.find_first_of("123456789") != std::string_view::npos) return filling;
    begin = text.find('(', begin + 1);
  }
  return {};
}

}  // namespace

bool looks_like_signature(std::string_view text) {
  text = detail::trimmed(text);
  if (!looks_like_isosig(signature_of(text))) return false;
  for (const char c : text.substr(signature_of(text).size())) {
    const bool is_alphanumeric =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!is_alphanumeric && std::string_view("_.(),+-").find(c) == std::string_view::npos)
      return false;
  }
  return true;
}

NamedGluings read_signature(std::string_view text) {
  text = detail::trimmed(text);
  const std::string_view signature = signature_of(text);
  const std::string_view behind = text.substr(signature.size());
  if (const std::string_view filling = first_filling(behind); !filling.empty())
    throw Unsupported(quoted(std::string(text)) + " has the Dehn filling " +
                      quoted(std::string(filling)) +
                      "; fillings are not supported yet: triangulate the filled manifold first, in "
                      "SnapPy by filled_triangulation()");
  NamedGluings result{std::string(signature), decode_isosig(signature)};
  result.orientation_known = isosig_sign(signature) != 0;
  if (behind.starts_with('_'))
    result.notes.push_back("the peripheral curves of the decorated signature not read");
  if (behind.starts_with('.')) result.notes.push_back("the locks of the signature not read");
  return result;
}

}  // namespace tripus::topology

namespace tripus::topology::registered_formats {

std::span<const Format> signature() {
  static constexpr Format kRows[] = {
      {kIsomorphismSignature, looks_like_signature, read_one<read_signature>, 5}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
