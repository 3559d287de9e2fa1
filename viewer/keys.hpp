#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tripus::viewer {

/// What keys and the mouse do, in the window as in the page.
enum class KeyAction : std::uint8_t {
  kNone,  ///< named in the help only: what pointers and held keys do
  kNearer,
  kFarther,
  kFewerCells,
  kMoreCells,
  kChangeModel,
  kChangeColour,
  kChangeView,
  kFaces,
  kTruncations,
  kDiscs,
  kLines,
  kHollow,
  kNooks,
  kCut,
  kCutBack,
  kCutForth,
  kTransparent,
  kLabels,
  kPicture,
  kLink,
  kFirstView,
  kTheme,
  kRate,
  kHelp,
};

/// A line of the one list of keys.
struct KeyLine {
  std::string_view keys;  ///< as people read them; where there is an action, one character
  KeyAction action = KeyAction::kNone;
  std::string_view name;  ///< of the action, in the page's scripts
  std::string_view text;  ///< empty: another line says it
  bool in_window = true;
  bool in_page = true;
};

/// The list: window and page act by it, and show it as help.
std::span<const KeyLine> key_lines();

/// What a character typed in the window asks for; capitals are small letters.
KeyAction window_action(char32_t character);

/// Breaks a text into lines of so many letters, at blanks; longer words stay whole. What does not
/// go into so many lines is left out, and " ..." says so.
std::string broken_at_blanks(std::string text, std::size_t letters,
                             std::size_t most_lines = SIZE_MAX);

/// The window's lines of the list: keys, and beside them what they do, broken into so many letters;
/// those that fit into so many lines.
std::array<std::string, 2> window_help(std::size_t letters = SIZE_MAX,
                                       std::size_t most_lines = SIZE_MAX);

}  // namespace tripus::viewer
