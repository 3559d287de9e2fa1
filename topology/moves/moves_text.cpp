#include <charconv>
#include <string>

#include "base/error.hpp"
#include "topology/moves/moves.hpp"

// "2-3 at face 2 of tetrahedron 5", "0-2 at edge 03 of tetrahedron 5, side 1, steps 4".

namespace tripus::topology {
namespace {

std::string_view place_word(MovePlace place) {
  switch (place) {
    case MovePlace::kTetrahedron:
      return "tetrahedron";
    case MovePlace::kFace:
      return "face";
    case MovePlace::kEdge:
      return "edge";
    case MovePlace::kVertex:
      return "vertex";
  }
  throw InternalError("unknown MovePlace");
}

std::string place_number(const Move& move) {
  if (info(move.kind).place != MovePlace::kEdge) return std::to_string(move.place);
  const auto [a, b] = kEdgeEnds.at(move.place);
  return std::to_string(a) + std::to_string(b);
}

/// Takes words from the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text), rest_(text) {}

  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) fail("\"" + std::string(word) + "\"");
  }
  std::uint32_t number(std::uint32_t limit) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || value >= limit) fail("a number less than " + std::to_string(limit));
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  std::uint8_t edge() {
    for (std::size_t e = 0; e < kEdgeEnds.size(); ++e)
      if (take(std::to_string(kEdgeEnds[e][0]) + std::to_string(kEdgeEnds[e][1])))
        return static_cast<std::uint8_t>(e);
    fail("an edge 01, 02, 03, 12, 13 or 23");
  }
  void finish() {
    if (!rest_.empty()) fail("the end");
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw InvalidInput("not a move: " + quoted(std::string(text_)) + "; expected " + expected +
                       " at character " + std::to_string(text_.size() - rest_.size() + 1));
  }

 private:
  std::string_view text_;
  std::string_view rest_;
};

MoveKind read_kind(Reader& reader) {
  for (const MoveInfo& line : move_table()) {
    Reader ahead = reader;
    if (!ahead.take(line.arrow) || !ahead.take(" at ") || !ahead.take(place_word(line.place)) ||
        !ahead.take(" "))
      continue;
    reader = ahead;
    return line.kind;
  }
  reader.fail("a move and its place, as in \"2-3 at face\"");
}

}  // namespace

std::string to_string(const Move& move) {
  const MoveInfo& line = info(move.kind);
  std::string text(line.arrow);
  text.append(" at ").append(place_word(line.place)).append(" ");
  if (line.place != MovePlace::kTetrahedron) text += place_number(move) + " of tetrahedron ";
  text += std::to_string(move.tetrahedron);
  if (!line.choice_name.empty())
    text.append(", ").append(line.choice_name).append(" ").append(std::to_string(move.choice));
  if (line.has_steps) text += ", steps " + std::to_string(move.steps);
  return text;
}

Move parse_move(std::string_view text) {
  Reader reader(text);
  Move move;
  move.kind = read_kind(reader);
  const MoveInfo& line = info(move.kind);
  if (line.place == MovePlace::kEdge)
    move.place = reader.edge();
  else if (line.place != MovePlace::kTetrahedron)
    move.place = static_cast<std::uint8_t>(reader.number(4));
  if (line.place != MovePlace::kTetrahedron) reader.expect(" of tetrahedron ");
  move.tetrahedron = reader.number(static_cast<std::uint32_t>(kMaxTetrahedra));
  if (!line.choice_name.empty()) {
    reader.expect(", " + std::string(line.choice_name) + " ");
    move.choice = static_cast<std::uint8_t>(reader.number(2));
  }
  if (line.has_steps) {
    reader.expect(", steps ");
    move.steps = reader.number(0xffffffffu);
  }
  reader.finish();
  return move;
}

}  // namespace tripus::topology
