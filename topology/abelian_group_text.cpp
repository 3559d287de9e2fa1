// Abelian groups from text, in the spellings of Regina, SnapPy, Magma, LaTeX and people.
#include <algorithm>
#include <charconv>
#include <optional>

#include "base/big_number.hpp"
#include "base/error.hpp"
#include "topology/homology.hpp"

namespace tripus::topology {
namespace {

constexpr std::size_t kMostCopies = 100'000;
constexpr std::size_t kMostDigits = 1000;

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Without white space, braces and parentheses, and with one spelling of Z and of +.
std::string plain_spelling(std::string_view given) {
  std::string text(given);
  replace_all(text, "\u2124", "Z");
  replace_all(text, "\u2295", "+");
  replace_all(text, "\u00d7", "+");
  replace_all(text, "\\mathbb", "");
  replace_all(text, "\\oplus", "+");
  std::string result;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '{' || c == '}' || c == '(' || c == ')' || c == '*') continue;
    result += c == 'z' ? 'Z' : c == ',' || c == 'x' ? '+' : c;
  }
  return result;
}

class GroupReader {
 public:
  explicit GroupReader(std::string_view given) : given_(given), text_(plain_spelling(given)) {}

  AbelianGroup read() {
    if (text_ == "0" || text_ == "1" || text_ == "trivial") return {};
    do {
      read_term();
    } while (take('+'));
    if (place_ != text_.size()) refuse();
    return group();
  }

 private:
  [[noreturn]] void refuse() const {
    throw InvalidInput(quoted(std::string(given_)) +
                       " is no abelian group; write it as \"2 Z + Z_3\", Z^2+Z/3 or 0");
  }
  bool take(char c) {
    if (place_ >= text_.size() || text_[place_] != c) return false;
    ++place_;
    return true;
  }
  std::optional<std::string> digits() {
    const std::size_t begin = place_;
    while (place_ < text_.size() && text_[place_] >= '0' && text_[place_] <= '9') ++place_;
    if (place_ - begin > kMostDigits) refuse();
    if (place_ == begin) return std::nullopt;
    return text_.substr(begin, place_ - begin);
  }
  std::size_t copies(const std::optional<std::string>& number) const {
    std::size_t value = 1;
    if (!number) return value;
    const char* const end = number->data() + number->size();
    if (std::from_chars(number->data(), end, value).ec != std::errc() || value > kMostCopies)
      refuse();
    return value;
  }

  /// [copies] Z [order] [^ copies] or [copies] Z [^ copies] [order]
  void read_term() {
    std::size_t count = copies(digits());
    if (!take('Z')) refuse();
    const auto power = [&] {
      if (!take('^')) return;
      const auto exponent = digits();
      if (!exponent) refuse();
      count *= copies(exponent);
      if (count > kMostCopies) refuse();
    };
    power();
    const bool marked = take('_') || take('/');
    const auto order = digits();
    if (marked && !order) refuse();
    if (marked) take('Z');  // Z/3Z
    power();
    const BigInteger modulus = order ? BigInteger(*order) : BigInteger(0);
    if (order && modulus == 0 && !marked) refuse();
    if (modulus == 0) {
      rank_ += count;
    } else if (modulus > 1) {
      torsion_.insert(torsion_.end(), count, modulus);
    }
  }

  /// Pairs become (gcd, lcm) until each factor divides the next.
  AbelianGroup group() {
    for (std::size_t i = 0; i < torsion_.size(); ++i)
      for (std::size_t j = i + 1; j < torsion_.size(); ++j) {
        if (torsion_[j] % torsion_[i] == 0) continue;
        const BigInteger divisor = gcd(torsion_[i], torsion_[j]);
        torsion_[j] = torsion_[i] / divisor * torsion_[j];
        torsion_[i] = divisor;
      }
    AbelianGroup result;
    result.rank = rank_;
    for (const BigInteger& factor : torsion_)
      if (factor > 1) result.invariant_factors.push_back(to_decimal(factor));
    return result;
  }

  std::string_view given_;
  std::string text_;
  std::size_t place_ = 0;
  std::size_t rank_ = 0;
  std::vector<BigInteger> torsion_;
};

}  // namespace

AbelianGroup parse_abelian_group(std::string_view text) { return GroupReader(text).read(); }

}  // namespace tripus::topology
