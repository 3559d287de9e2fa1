#pragma once

#include <string_view>

#include "meshing/detail/scanner.hpp"

namespace tripus::meshing::detail {

/// The words of an OBJ line, which goes on behind a "\" at its end.
class ObjLine {
 public:
  explicit ObjLine(Scanner& in) : in_(in) {}

  std::string_view word() {
    std::string_view found = in_.word_of_line();
    while (found == "\\" && in_.next_line()) found = in_.word_of_line();
    if (found.size() > 1 && found.ends_with('\\')) {
      in_.put_back(1);
      found.remove_suffix(1);
    }
    return found;
  }
  /// To its end.
  void skip() {
    while (in_.rest_of_line().ends_with('\\') && in_.next_line()) {
    }
    in_.skip_line();
  }

 private:
  Scanner& in_;
};

}  // namespace tripus::meshing::detail
