#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace tripus::detail {

/// Deeper nesting than any document of ours has; the parser stops there.
constexpr std::size_t kDeepestJson = 32;

/// A number as nlohmann reads it.
struct PlainNumbers {
  template <class Tree, class Number>
  static Tree keep(Number value) {
    return Tree(value);
  }
  template <class Tree>
  static Tree keep(typename Tree::number_float_t value, const std::string& /*text*/) {
    return Tree(value);
  }
};

/// Makes a tree of nlohmann's events; their names and signatures are nlohmann's. `Numbers` says
/// what becomes of numbers.
template <class Tree, class Numbers>
class GuardedBuilder {
 public:
  using number_integer_t = typename Tree::number_integer_t;
  using number_unsigned_t = typename Tree::number_unsigned_t;
  using number_float_t = typename Tree::number_float_t;
  using string_t = typename Tree::string_t;
  using binary_t = typename Tree::binary_t;

  explicit GuardedBuilder(std::string_view expected) : expected_(expected) {}

  bool null() { return add(Tree()); }
  bool boolean(bool value) { return add(Tree(value)); }
  bool number_integer(number_integer_t value) { return add(Numbers::template keep<Tree>(value)); }
  bool number_unsigned(number_unsigned_t value) { return add(Numbers::template keep<Tree>(value)); }
  bool number_float(number_float_t value, const string_t& text) {
    return add(Numbers::template keep<Tree>(value, text));
  }
  bool string(string_t& value) { return add(Tree(std::move(value))); }
  bool binary(binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) { return open(Tree::object()); }
  bool start_array(std::size_t /*size*/) { return open(Tree::array()); }
  bool key(string_t& name) {
    if (open_.back()->contains(name))
      throw InvalidInput("JSON: the key " + tripus::quoted(name) + " occurs twice in one object");
    key_ = std::move(name);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t byte, const std::string& /*token*/,
                   const typename Tree::exception& error) {
    const std::string place = " byte " + std::to_string(byte);
    if (dynamic_cast<const typename Tree::out_of_range*>(&error) != nullptr)
      throw InvalidInput("JSON: the number before" + place +
                         " is too large; numbers must be finite");
    throw InvalidInput("JSON: syntax error at" + place + "; expected " + std::string(expected_));
  }

  Tree take() { return std::move(root_); }

 private:
  Tree* place(Tree value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Tree& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    Tree& member = parent[key_];
    member = std::move(value);
    return &member;
  }
  bool add(Tree value) {
    place(std::move(value));
    return true;
  }
  /// The pointers stay valid: only the innermost open container grows.
  bool open(Tree value) {
    if (open_.size() == kDeepestJson)
      throw InvalidInput("JSON: nested more than " + std::to_string(kDeepestJson) + " levels deep");
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view expected_;
  Tree root_;
  std::vector<Tree*> open_;
  std::string key_;
};

/// The document, made by people or programs unknown: no key twice, nesting of kDeepestJson at most,
/// no number beyond the tree's. Throws InvalidInput with the place, and what was expected.
template <class Tree = nlohmann::json, class Numbers = PlainNumbers>
Tree parse_guarded_json(std::string_view text, std::string_view expected) {
  GuardedBuilder<Tree, Numbers> builder(expected);
  Tree::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace tripus::detail
