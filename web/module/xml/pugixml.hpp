// What Tripus uses of pugixml's interface, for builds that have no pugixml to link: elements,
// attributes and text. It knows no DTD; entities are the five of XML and numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pugi {

namespace detail {

struct Element {
  std::string name;
  std::string text;  ///< the first that is not white space
  std::vector<std::pair<std::string, std::string>> attributes;
  Element* parent = nullptr;
  Element* next = nullptr;
  Element* first = nullptr;
  Element* last = nullptr;
};

}  // namespace detail

class xml_attribute {
 public:
  explicit xml_attribute(std::string* value = nullptr) : value_(value) {}
  explicit operator bool() const { return value_ != nullptr; }
  const char* value() const { return value_ != nullptr ? value_->c_str() : ""; }
  void operator=(const char* text) { *value_ = text; }
  void operator=(int number) { *value_ = std::to_string(number); }
  void operator=(unsigned long long number) { *value_ = std::to_string(number); }

 private:
  std::string* value_;
};

class xml_text {
 public:
  explicit xml_text(std::string& text) : text_(text) {}
  void operator=(const char* text) { text_ = text; }

 private:
  std::string& text_;
};

class xml_document;

class xml_node {
 public:
  xml_node() = default;
  explicit operator bool() const { return element_ != nullptr; }

  const char* name() const { return element_ != nullptr ? element_->name.c_str() : ""; }
  const char* child_value() const { return element_ != nullptr ? element_->text.c_str() : ""; }
  xml_node parent() const { return of(element_ != nullptr ? element_->parent : nullptr); }
  xml_node first_child() const { return of(element_ != nullptr ? element_->first : nullptr); }
  xml_node next_sibling() const { return of(element_ != nullptr ? element_->next : nullptr); }

  xml_attribute attribute(std::string_view name) const {
    if (element_ != nullptr) {
      for (auto& [key, value] : element_->attributes)
        if (key == name) return xml_attribute(&value);
    }
    return xml_attribute();
  }
  std::vector<xml_node> children(std::string_view name) const {
    std::vector<xml_node> found;
    for (xml_node each = first_child(); each; each = each.next_sibling())
      if (each.name() == name) found.push_back(each);
    return found;
  }
  xml_node child(std::string_view name) const {
    for (xml_node each = first_child(); each; each = each.next_sibling())
      if (each.name() == name) return each;
    return {};
  }

  inline xml_node append_child(const char* name);
  xml_attribute append_attribute(const char* name) {
    element_->attributes.emplace_back(name, "");
    return xml_attribute(&element_->attributes.back().second);
  }
  xml_text text() const { return xml_text(element_->text); }

 private:
  friend class xml_document;
  xml_node of(detail::Element* element) const {
    xml_node node;
    node.element_ = element;
    node.document_ = document_;
    return node;
  }

  detail::Element* element_ = nullptr;
  xml_document* document_ = nullptr;
};

struct xml_parse_result {
  std::ptrdiff_t offset = 0;
  const char* problem = nullptr;
  explicit operator bool() const { return problem == nullptr; }
  const char* description() const { return problem != nullptr ? problem : "No error"; }
};

class xml_writer {
 public:
  virtual ~xml_writer() = default;
  virtual void write(const void* data, std::size_t size) = 0;
};

/// The document is the parent of its topmost elements, and has no name.
class xml_document : public xml_node {
 public:
  xml_document() {
    document_ = this;
    element_ = &elements_.emplace_back();
  }
  xml_document(const xml_document&) = delete;
  xml_document& operator=(const xml_document&) = delete;

  xml_parse_result load_buffer(const void* data, std::size_t size) {
    text_ = std::string_view(static_cast<const char*>(data), size);
    at_ = 0;
    if (const char* problem = parse()) return {static_cast<std::ptrdiff_t>(at_), problem};
    return {};
  }

  void save(xml_writer& writer, const char* indent) const {
    std::string out = "<?xml version=\"1.0\"?>\n";
    const detail::Element* element = element_->first;
    for (std::size_t depth = 0; element != nullptr;) {
      for (std::size_t i = 0; i < depth; ++i) out += indent;
      out += '<' + element->name;
      for (const auto& [key, value] : element->attributes)
        out += ' ' + key + "=\"" + escaped(value) + '"';
      if (element->first != nullptr) {
        out += ">\n";
        element = element->first;
        ++depth;
        continue;
      }
      out += element->text.empty() ? " />\n"
                                   : '>' + escaped(element->text) + "</" + element->name + ">\n";
      while (element != element_ && element->next == nullptr) {
        element = element->parent;
        if (element == element_) break;
        --depth;
        for (std::size_t i = 0; i < depth; ++i) out += indent;
        out += "</" + element->name + ">\n";
      }
      element = element == element_ ? nullptr : element->next;
    }
    writer.write(out.data(), out.size());
  }

 private:
  friend class xml_node;

  detail::Element* add(detail::Element* parent, std::string_view name) {
    detail::Element* element = &elements_.emplace_back();
    element->name = name;
    element->parent = parent;
    (parent->last != nullptr ? parent->last->next : parent->first) = element;
    parent->last = element;
    return element;
  }

  static std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
      switch (c) {
        case '&':
          out += "&amp;";
          break;
        case '<':
          out += "&lt;";
          break;
        case '"':
          out += "&quot;";
          break;
        default:
          out += c;
      }
    }
    return out;
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  bool ends() const { return at_ >= text_.size(); }
  bool starts(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip_space() {
    while (!ends() && is_space(text_[at_])) ++at_;
  }
  /// Goes behind the next `end`, or says that there is none.
  bool skip_behind(std::string_view end) {
    const std::size_t place = text_.find(end, at_);
    at_ = place == std::string_view::npos ? text_.size() : place + end.size();
    return place != std::string_view::npos;
  }
  static bool is_of_name(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte >= 0x80 ||
           (byte >= '0' && byte <= '9') || byte == '_' || byte == ':' || byte == '-' || byte == '.';
  }
  /// Empty where no name begins.
  std::string_view take_name() {
    const std::size_t start = at_;
    if (!ends() &&
        (text_[at_] == '-' || text_[at_] == '.' || (text_[at_] >= '0' && text_[at_] <= '9')))
      return {};
    while (!ends() && is_of_name(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  /// A character by its number, as UTF-8.
  static std::string character(unsigned long code) {
    const auto part = [&](unsigned shift, unsigned lead) {
      return static_cast<char>(lead | (code >> shift & 0x3F));
    };
    if (code < 0x80) return {static_cast<char>(code)};
    if (code < 0x800) return {static_cast<char>(0xC0 | code >> 6), part(0, 0x80)};
    if (code < 0x10000) return {static_cast<char>(0xE0 | code >> 12), part(6, 0x80), part(0, 0x80)};
    return {static_cast<char>(0xF0 | (code >> 18 & 7)), part(12, 0x80), part(6, 0x80),
            part(0, 0x80)};
  }

  static std::string unescaped(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
        {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::size_t end = text[i] == '&' ? text.find(';', i) : std::string_view::npos;
      if (end == std::string_view::npos || end - i > 10) {
        out += text[i];
        continue;
      }
      const std::string word(text.substr(i + 1, end - i - 1));
      std::string meant;
      for (const auto& [name, c] : kEntities)
        if (word == name) meant = c;
      if (word.size() > 1 && word[0] == '#') {
        const bool hexadecimal = word[1] == 'x';
        char* rest = nullptr;
        const unsigned long code =
            std::strtoul(word.c_str() + (hexadecimal ? 2 : 1), &rest, hexadecimal ? 16 : 10);
        if (*rest == 0 && code > 0 && code < 0x110000) meant = character(code);
      }
      if (meant.empty()) {
        out += text[i];
        continue;
      }
      out += meant;
      i = end;
    }
    return out;
  }

  static bool is_blank(std::string_view text) {
    for (const char c : text)
      if (!is_space(c)) return false;
    return true;
  }
  static void add_text(detail::Element& element, std::string_view text, bool is_literal) {
    if (!element.text.empty() || is_blank(text)) return;
    element.text = is_literal ? std::string(text) : unescaped(text);
  }

  /// Behind the name of an opening tag. Sets whether it closes itself.
  const char* parse_attributes(detail::Element& element, bool& closed) {
    while (true) {
      skip_space();
      if (ends()) return "Error parsing start element tag";
      if (starts("/>")) {
        at_ += 2;
        closed = true;
        return nullptr;
      }
      if (text_[at_] == '>') {
        ++at_;
        closed = false;
        return nullptr;
      }
      const std::string_view name = take_name();
      skip_space();
      if (name.empty() || ends() || text_[at_] != '=') return "Error parsing element attribute";
      ++at_;
      skip_space();
      if (ends() || (text_[at_] != '"' && text_[at_] != '\''))
        return "Error parsing element attribute";
      const char quote = text_[at_++];
      const std::size_t end = text_.find(quote, at_);
      if (end == std::string_view::npos) return "Error parsing element attribute";
      element.attributes.emplace_back(name, unescaped(text_.substr(at_, end - at_)));
      at_ = end + 1;
    }
  }

  /// What is wrong, or null. Deep nesting costs nothing: there is no recursion.
  const char* parse() {
    detail::Element* here = element_;
    if (starts("\xEF\xBB\xBF")) at_ += 3;
    while (!ends()) {
      const std::size_t open = std::min(text_.find('<', at_), text_.size());
      add_text(*here, text_.substr(at_, open - at_), false);
      at_ = open;
      if (ends()) break;
      if (starts("<!--")) {
        if (!skip_behind("-->")) return "Error parsing comment";
      } else if (starts("<![CDATA[")) {
        const std::size_t start = at_ + 9;
        if (!skip_behind("]]>")) return "Error parsing CDATA section";
        add_text(*here, text_.substr(start, at_ - 3 - start), true);
      } else if (starts("<?") || starts("<!DOCTYPE")) {
        if (!skip_behind(">")) return "Error parsing document declaration/processing instruction";
      } else if (starts("</")) {
        at_ += 2;
        const std::string_view name = take_name();
        skip_space();
        if (here == element_ || name != here->name || ends() || text_[at_] != '>')
          return "Start-end tags mismatch";
        ++at_;
        here = here->parent;
      } else {
        ++at_;
        const std::string_view name = take_name();
        if (name.empty()) return "Could not determine tag type";
        detail::Element* element = add(here, name);
        bool closed = false;
        if (const char* problem = parse_attributes(*element, closed)) return problem;
        if (!closed) here = element;
      }
    }
    if (here != element_) return "Start-end tags mismatch";
    return element_->first == nullptr ? "No document element found" : nullptr;
  }

  std::deque<detail::Element> elements_;
  std::string_view text_;
  std::size_t at_ = 0;
};

inline xml_node xml_node::append_child(const char* name) {
  return of(document_->add(element_, name));
}

}  // namespace pugi
