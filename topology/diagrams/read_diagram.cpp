#include "topology/diagrams/read_diagram.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "base/error.hpp"
#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology {
namespace {

using detail::DiagramScanner;

/// The text without white space and comments in front.
std::string_view opened(std::string_view text) {
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  DiagramScanner scan(text);
  scan.peek();
  return text.substr(scan.position());
}

/// X[, xp(, V_{ ... or, in a text of several words, X1425: a node with its kind.
bool starts_node(std::string_view text) {
  DiagramScanner scan(text);
  const std::string_view word = scan.letters();
  constexpr std::array<std::string_view, 9> kWords{"X", "Xp", "Xm",   "Xn",  "V",
                                                   "P", "B",  "Loop", "Cone"};
  const auto same = [&](std::string_view each) { return DiagramScanner::same_word(word, each); };
  if (std::ranges::none_of(kWords, same)) return false;
  if (scan.peek_raw() == '_') scan.take_any();
  return detail::is_opening(scan.peek_raw()) ||
         (word == "X" && detail::is_digit(scan.peek_raw()) &&
          text.find_first_of(" ,\n") != std::string_view::npos);
}

/// Lists of numbers in which each crossing stands once with a plus and once with a minus sign: a
/// Gauss code without a heading. No planar diagram is like that.
bool is_bare_gauss(std::string_view text) {
  if (text.find('-') == std::string_view::npos) return false;
  std::map<std::int64_t, std::array<int, 2>> times;
  DiagramScanner scan(text);
  try {
    while (!scan.at_end()) {
      if (scan.at_number()) {
        const std::int64_t number = scan.integer();
        ++times[number < 0 ? -(number + 1) : number - 1][number > 0];
      } else if (std::string_view("[](){},").find(scan.take_any()) == std::string_view::npos) {
        return false;
      }
    }
  } catch (const InvalidInput&) {  // a number that is too large
    return false;
  }
  return !times.empty() && std::ranges::all_of(times, [](const auto& each) {
    return each.second == std::array{1, 1};
  });
}
bool is_gauss(std::string_view text) {
  for (const std::string_view word : {"Gauss", "GaussCode"})
    if (detail::has_heading(text, word)) return true;
  if ((text[0] == 'O' || text[0] == 'U') && text.size() > 2 && detail::is_digit(text[1])) {
    const std::size_t sign = text.find_first_not_of("0123456789", 1);  // O1+U2+, no signature O1
    return sign + 1 < text.size() && (text[sign] == '+' || text[sign] == '-');
  }
  return detail::is_opening(text[0]) && is_bare_gauss(text);
}

bool is_pd(std::string_view text) {
  if (detail::has_heading(text, "PD") || starts_node(text)) return true;
  // Two brackets and a number: a list of lists; one round one: tuples. JSON's objects hold quotes.
  if (!detail::is_opening(text[0])) return false;
  DiagramScanner scan(text.substr(1));
  const char c = scan.peek();
  if (DiagramScanner::is_letter(c)) return starts_node(text.substr(1 + scan.position()));
  if (text[0] == '(' && scan.at_number()) return true;
  if (!detail::is_opening(c)) return false;
  scan.take_any();
  return scan.at_number();
}
bool is_json(std::string_view text) {
  return text[0] == '{' &&
         (text.find("\"diagram\"") != std::string_view::npos || text.starts_with("{'diagram'"));
}
bool is_dt(std::string_view text) {
  return detail::has_heading(text, "DT") || detail::has_heading(text, "DTCode");
}
/// Numbers alone in one square or curly bracket: KnotInfo's [4, 6, 8, 2] is a DT code.
bool is_list(std::string_view text) {
  if (text[0] != '[' && text[0] != '{') return false;
  DiagramScanner scan(text.substr(1));
  std::size_t count = 0;
  for (; scan.at_number(); ++count) {
    (void)scan.until(", ]}\n");
    scan.take(',');
  }
  return count > 1 && detail::is_closing(scan.peek());
}
NamedDiagram read_list(std::string_view text) {
  DiagramScanner scan(text.substr(1));
  while (scan.at_number()) {
    if (scan.integer() % 2 != 0)
      throw InvalidInput(
          "numbers alone do not say what they are; write Braid: [1,-2,1,-2], DT: [4,6,8,2] or "
          "Gauss: "
          "[1,-2,3,-1,2,-3]");
    scan.take(',');
  }
  return detail::read_dt_code(text);
}
bool is_braid(std::string_view text) {
  return detail::has_heading(text, "Braid") || detail::has_heading(text, "BR");
}
bool is_embedding(std::string_view text) { return detail::has_heading(text, "embedding"); }
/// With appcontour's contours, which are refused by name.
bool is_picture(std::string_view text) {
  DiagramScanner scan(text);
  const std::string_view word = scan.letters();
  return (word == "knot" || word == "morse" || word == "sketch") && scan.peek() == '{';
}
bool is_knotpy(std::string_view text) {
  DiagramScanner scan(text);
  return !scan.letters().empty() && scan.take('=') && (scan.take('V') || scan.take('X')) &&
         scan.take('(');
}

struct Form {
  std::string_view name;
  bool (*matches)(std::string_view);  ///< given a text that is not empty
  NamedDiagram (*read)(std::string_view);
};

/// The first that matches is taken.
constexpr std::array kForms{
    Form{"planar diagram in JSON", is_json, detail::read_diagram_json},
    Form{"Gauss code (Gauss:)", is_gauss, detail::read_gauss_code},
    Form{"planar diagram (PD: X[...] V[...])", is_pd, detail::read_pd_text},
    Form{"Dowker-Thistlethwaite code (DT:)", is_dt, detail::read_dt_code},
    Form{"list of even numbers (a DT code)", is_list, read_list},
    Form{"braid (Braid:)", is_braid, detail::read_braid},
    Form{"embedding of appcontour", is_embedding, detail::read_embedding},
    Form{"picture of appcontour (knot {)", is_picture, detail::read_knot_picture},
    Form{"diagram of KnotPy", is_knotpy, detail::read_knotpy},
};

const Form* find_form(std::string_view text) {
  if (text.empty()) return nullptr;
  const auto found = std::ranges::find_if(kForms, [&](const Form& f) { return f.matches(text); });
  return found == kForms.end() ? nullptr : &*found;
}

}  // namespace

namespace detail {

void turn_round(std::vector<DiagramNode>& nodes) {
  for (DiagramNode& node : nodes)
    if (node.arcs.size() > 1) std::reverse(node.arcs.begin() + 1, node.arcs.end());
}

}  // namespace detail

bool looks_like_diagram(std::string_view text) { return find_form(opened(text)) != nullptr; }

std::string diagram_format_names() {
  std::string names;
  for (const Form& form : kForms) names += (names.empty() ? "" : ", ") + std::string(form.name);
  return names;
}

NamedDiagram read_diagram(std::string_view text) {
  const std::string_view content = opened(text);
  const Form* form = find_form(content);
  if (form == nullptr)
    throw InvalidInput("it is no diagram; expected one of: " + diagram_format_names());
  return form->read(content);
}

std::string pd_text(const NamedDiagram& diagram) {
  std::string text = "PD: " + to_text(diagram.diagram);
  for (const DiagramLabel& label : diagram.labels)
    text += " Cone[" + std::to_string(label.arc) + "," + label.angle.order_text() + "]";
  return text;
}

}  // namespace tripus::topology
