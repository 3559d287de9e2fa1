#include "topology/diagrams/read_diagram.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology {
namespace {

using detail::Scanner;

/// The text without white space and comments in front.
std::string_view opened(std::string_view text) {
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  Scanner scan(text);
  scan.peek();
  return text.substr(scan.position());
}

/// X[, Xp(, V_{ ...: a node with its kind.
bool starts_node(std::string_view text) {
  Scanner scan(text);
  const std::string_view word = scan.letters();
  constexpr std::array<std::string_view, 9> kWords{"X", "Xp", "Xm",   "Xn",  "V",
                                                   "P", "B",  "Loop", "Cone"};
  if (std::ranges::find(kWords, word) == kWords.end()) return false;
  if (scan.peek_raw() == '_') scan.take_any();
  return detail::is_opening(scan.peek_raw());
}

bool is_pd(std::string_view text) {
  if (text.starts_with("PD")) return text.size() > 2 && !Scanner::is_letter(text[2]);
  if (starts_node(text)) return true;
  // Two brackets and a number: a list of lists; one round one: tuples. JSON's objects hold quotes.
  if (!detail::is_opening(text[0])) return false;
  Scanner scan(text.substr(1));
  const char c = scan.peek();
  if (Scanner::is_letter(c)) return starts_node(text.substr(1 + scan.position()));
  if (text[0] == '(' && scan.at_number()) return true;
  if (c != '[' && c != '(') return false;
  scan.take_any();
  return scan.at_number();
}
bool is_json(std::string_view text) {
  return text[0] == '{' && text.find("\"diagram\"") != std::string_view::npos;
}
bool is_dt(std::string_view text) { return text.starts_with("DT:") || text.starts_with("DT["); }
bool is_braid(std::string_view text) {
  for (const std::string_view word : {"Braid", "braid", "BR"})
    if (text.starts_with(word) && text.size() > word.size() &&
        (text[word.size()] == ':' || text[word.size()] == '['))
      return true;
  return false;
}
bool is_embedding(std::string_view text) {
  return text.starts_with("embedding:") || text.starts_with("embedding {");
}
bool is_knotpy(std::string_view text) {
  Scanner scan(text);
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
    Form{"planar diagram (PD: X[...] V[...])", is_pd, detail::read_pd_text},
    Form{"planar diagram in JSON", is_json, detail::read_diagram_json},
    Form{"Dowker-Thistlethwaite code (DT:)", is_dt, detail::read_dt_code},
    Form{"braid (Braid:)", is_braid, detail::read_braid},
    Form{"embedding of appcontour", is_embedding, detail::read_embedding},
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
