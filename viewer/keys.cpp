#include "viewer/keys.hpp"

#include <algorithm>

namespace tripus::viewer {
namespace {

constexpr auto kLines = std::to_array<KeyLine>({
    {"drag, arrows", KeyAction::kNone, "", "turn; inside: look"},
    {"W A S D R F", KeyAction::kNone, "", "move by Moebius maps; inside: walk, rise, sink"},
    {"Q E", KeyAction::kNone, "", "inside: roll"},
    {"Shift drag, right drag", KeyAction::kNone, "", "shift"},
    {"wheel, + -", KeyAction::kNone, "", "nearer and farther, the wheel towards the pointer"},
    {"+", KeyAction::kNearer, "", "", true, false},
    {"-", KeyAction::kFarther, "", "", true, false},
    {",", KeyAction::kFewerCells, "fewer cells", "fewer cells"},
    {".", KeyAction::kMoreCells, "more cells", "more cells"},
    {"M", KeyAction::kChangeModel, "change model", "ball, upper half-space, Klein ball"},
    {"C", KeyAction::kChangeColour, "change colour",
     "colour by tetrahedron, face, depth, boundary component, edge"},
    {"I", KeyAction::kChangeView, "change view", "inside or outside"},
    {"1", KeyAction::kFaces, "faces", "faces on and off"},
    {"2", KeyAction::kTruncations, "truncations", "truncations on and off"},
    {"3", KeyAction::kDiscs, "discs", "discs of arcs on and off, where there are some"},
    {"4", KeyAction::kLines, "lines", "lines on and off"},
    {"5", KeyAction::kHollow, "hollow", "solid or hollow"},
    {"6", KeyAction::kNooks, "", "dark nooks on and off", true, false},
    {"X", KeyAction::kCut, "cut", "cut away"},
    {"[", KeyAction::kCutBack, "cut back", "move the cut back"},
    {"]", KeyAction::kCutForth, "cut forth", "move the cut forth"},
    {"T", KeyAction::kTransparent, "transparent",
     "the tetrahedron under the pointer transparent, or none"},
    {"N", KeyAction::kLabels, "labels", "names of tetrahedra and edges"},
    {"P", KeyAction::kPicture, "save", "save the picture"},
    {"L", KeyAction::kLink, "link", "copy what shows this very view"},
    {"0", KeyAction::kFirstView, "reset", "first view again"},
    {"V", KeyAction::kTheme, "theme", "light or dark"},
    {"G", KeyAction::kRate, "rate", "frames a second"},
    {"H", KeyAction::kHelp, "help", "this help"},
    {"?", KeyAction::kHelp, "help", "this help", false},
    {"Esc", KeyAction::kNone, "", "close the window", true, false},
});

}  // namespace

std::span<const KeyLine> key_lines() { return kLines; }

KeyAction window_action(char32_t character) {
  if (character >= 'a' && character <= 'z') character -= 'a' - 'A';
  if (character == '=') character = '+';  // where + needs Shift
  for (const KeyLine& line : kLines) {
    const bool one = line.keys.size() == 1 && static_cast<char32_t>(line.keys[0]) == character;
    if (one && line.in_window) return line.action;
  }
  return KeyAction::kNone;
}

std::string broken_at_blanks(std::string text, std::size_t letters, std::size_t most_lines) {
  std::size_t lines = 1;
  for (std::size_t begin = 0; text.size() - begin > letters; ++lines) {
    std::size_t blank = text.rfind(' ', begin + letters);
    if (blank == std::string::npos || blank <= begin) blank = text.find(' ', begin + letters);
    if (blank == std::string::npos) break;
    if (lines >= most_lines) {
      text.resize(blank);
      return text + " ...";
    }
    text[blank] = '\n';
    begin = blank + 1;
  }
  return text;
}

std::array<std::string, 2> window_help(std::size_t letters, std::size_t most_lines) {
  std::array<std::string, 2> columns;
  std::size_t lines = 0;
  for (const KeyLine& line : kLines) {
    if (!line.in_window || line.text.empty()) continue;
    const std::string text = broken_at_blanks(std::string(line.text), letters);
    const auto taken = 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (lines + taken > most_lines) break;
    lines += taken;
    (columns[0] += line.keys) += std::string(taken, '\n');
    (columns[1] += text) += '\n';
  }
  for (std::string& column : columns)
    if (!column.empty()) column.pop_back();
  return columns;
}

}  // namespace tripus::viewer
