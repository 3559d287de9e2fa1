#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

namespace tripus::detail {

template <class Number>
concept BuiltInNumber = std::is_arithmetic_v<Number>;

/// What of mpz_class Tripus uses, in Boost's integers.
class BoostInteger {
 public:
  using Value = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;
  BoostInteger() = default;
  template <BuiltInNumber Number>
  BoostInteger(Number value) : value_(static_cast<Value>(value)) {}  // doubles: rounded to 0
  explicit BoostInteger(Value value) : value_(std::move(value)) {}
  /// Decimal digits, with a minus sign or without.
  BoostInteger(const std::string& digits, int /*ten*/) : value_(without_zeros(digits)) {}

  const Value& value() const { return value_; }
  std::string get_str() const { return value_.str(); }

  BoostInteger& operator+=(const BoostInteger& other) { return value_ += other.value_, *this; }
  BoostInteger& operator-=(const BoostInteger& other) { return value_ -= other.value_, *this; }
  BoostInteger& operator*=(const BoostInteger& other) { return value_ *= other.value_, *this; }
  BoostInteger& operator/=(const BoostInteger& other) { return value_ /= other.value_, *this; }
  BoostInteger& operator++() { return ++value_, *this; }
  BoostInteger operator-() const { return BoostInteger(Value(-value_)); }
  friend BoostInteger operator+(BoostInteger a, const BoostInteger& b) { return a += b; }
  friend BoostInteger operator-(BoostInteger a, const BoostInteger& b) { return a -= b; }
  friend BoostInteger operator*(BoostInteger a, const BoostInteger& b) { return a *= b; }
  friend bool operator==(const BoostInteger& a, const BoostInteger& b) {
    return a.value_ == b.value_;
  }
  friend bool operator<(const BoostInteger& a, const BoostInteger& b) {
    return a.value_ < b.value_;
  }
  friend bool operator>(const BoostInteger& a, const BoostInteger& b) { return b < a; }
  friend bool operator<=(const BoostInteger& a, const BoostInteger& b) { return !(b < a); }
  friend bool operator>=(const BoostInteger& a, const BoostInteger& b) { return !(a < b); }
  friend BoostInteger gcd(const BoostInteger& a, const BoostInteger& b) {
    return BoostInteger(Value(boost::multiprecision::gcd(a.value_, b.value_)));
  }
  friend BoostInteger lcm(const BoostInteger& a, const BoostInteger& b) {
    return BoostInteger(Value(boost::multiprecision::lcm(a.value_, b.value_)));
  }

 private:
  /// Boost reads a number that begins with 0 in base 8.
  static std::string without_zeros(const std::string& digits) {
    const bool negative = digits.starts_with('-');
    const std::size_t first = digits.find_first_not_of('0', negative ? 1 : 0);
    if (first == std::string::npos) return "0";
    return (negative ? "-" : "") + digits.substr(first);
  }

  Value value_;
};

/// What of mpq_class Tripus uses, in Boost's fractions.
class BoostRational {
 public:
  using Value = boost::multiprecision::number<
      boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
      boost::multiprecision::et_off>;
  BoostRational() = default;
  template <BuiltInNumber Number>
  BoostRational(Number value) : value_(static_cast<Value>(value)) {}
  BoostRational(const BoostInteger& value) : value_(value.value()) {}
  BoostRational(const BoostInteger& numerator, const BoostInteger& denominator)
      : value_(numerator.value(), denominator.value()) {}

  BoostInteger get_num() const {
    return BoostInteger(BoostInteger::Value(boost::multiprecision::numerator(value_)));
  }
  BoostInteger get_den() const {
    return BoostInteger(BoostInteger::Value(boost::multiprecision::denominator(value_)));
  }
  double get_d() const { return value_.convert_to<double>(); }

  BoostRational& operator+=(const BoostRational& other) { return value_ += other.value_, *this; }
  BoostRational& operator-=(const BoostRational& other) { return value_ -= other.value_, *this; }
  BoostRational& operator*=(const BoostRational& other) { return value_ *= other.value_, *this; }
  BoostRational& operator/=(const BoostRational& other) { return value_ /= other.value_, *this; }
  BoostRational operator-() const { return BoostRational(Value(-value_)); }
  friend BoostRational operator+(BoostRational a, const BoostRational& b) { return a += b; }
  friend BoostRational operator-(BoostRational a, const BoostRational& b) { return a -= b; }
  friend BoostRational operator*(BoostRational a, const BoostRational& b) { return a *= b; }
  friend BoostRational operator/(BoostRational a, const BoostRational& b) { return a /= b; }
  friend bool operator==(const BoostRational& a, const BoostRational& b) {
    return a.value_ == b.value_;
  }
  friend bool operator<(const BoostRational& a, const BoostRational& b) {
    return a.value_ < b.value_;
  }
  friend bool operator>(const BoostRational& a, const BoostRational& b) { return b < a; }
  friend bool operator<=(const BoostRational& a, const BoostRational& b) { return !(b < a); }
  friend bool operator>=(const BoostRational& a, const BoostRational& b) { return !(a < b); }

 private:
  explicit BoostRational(Value value) : value_(std::move(value)) {}
  Value value_;
};

}  // namespace tripus::detail
