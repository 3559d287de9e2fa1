#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tripus::topology {

/// A permutation of {0,1,2,3}: i goes to p(i). Stored as its lexicographic rank among the 24
/// words p(0)p(1)p(2)p(3), one byte. Products and inverses are table look-ups.
class Perm4 {
 public:
  constexpr Perm4() = default;  // the identity has rank 0

  static constexpr Perm4 from_rank(int rank) { return Perm4(static_cast<std::uint8_t>(rank)); }

  /// a, b, c, d must be a permutation of 0..3.
  static constexpr Perm4 from_images(int a, int b, int c, int d) {
    const int second = b - (b > a);
    const int third = (c > a) + (c > b);
    (void)d;
    return from_rank(6 * a + 2 * second + (c - third));
  }

  /// Exchanges i and j; the identity if they are equal.
  static constexpr Perm4 transposition(int i, int j) {
    const auto at = [&](int k) { return k == i ? j : k == j ? i : k; };
    return from_images(at(0), at(1), at(2), at(3));
  }

  constexpr int rank() const { return rank_; }
  constexpr int operator()(int i) const { return (kWords[rank_] >> (2 * i)) & 3; }

  /// (p * q)(i) = p(q(i)).
  friend constexpr Perm4 operator*(Perm4 p, Perm4 q) { return Perm4(kProducts[p.rank_][q.rank_]); }
  constexpr Perm4 inverse() const { return Perm4(kInverses[rank_]); }
  constexpr bool is_odd() const { return (kOddRanks >> rank_) & 1u; }

  friend constexpr bool operator==(Perm4, Perm4) = default;
  friend constexpr auto operator<=>(Perm4, Perm4) = default;

 private:
  explicit constexpr Perm4(std::uint8_t rank) : rank_(rank) {}

  static constexpr std::array<std::uint8_t, 24> make_words() {
    std::array<std::uint8_t, 24> words{};
    std::size_t rank = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        for (int c = 0; c < 4; ++c)
          if (a != b && a != c && b != c)
            words[rank++] = static_cast<std::uint8_t>(a | b << 2 | c << 4 | (6 - a - b - c) << 6);
    return words;
  }
  static constexpr std::uint32_t make_odd_ranks() {
    std::uint32_t odd = 0;
    const auto words = make_words();
    for (std::size_t rank = 0; rank < 24; ++rank) {
      int inversions = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          inversions += ((words[rank] >> (2 * i)) & 3) > ((words[rank] >> (2 * j)) & 3);
      odd |= static_cast<std::uint32_t>(inversions & 1) << rank;
    }
    return odd;
  }
  static constexpr int image(std::uint8_t word, int i) { return word >> (2 * i) & 3; }
  static constexpr std::array<std::array<std::uint8_t, 24>, 24> make_products() {
    std::array<std::array<std::uint8_t, 24>, 24> products{};
    const auto words = make_words();
    for (std::size_t p = 0; p < 24; ++p)
      for (std::size_t q = 0; q < 24; ++q) {
        const auto at = [&](int i) { return image(words[p], image(words[q], i)); };
        products[p][q] = from_images(at(0), at(1), at(2), at(3)).rank_;
      }
    return products;
  }
  static constexpr std::array<std::uint8_t, 24> make_inverses() {
    std::array<std::uint8_t, 24> inverses{};
    const auto words = make_words();
    for (std::size_t p = 0; p < 24; ++p) {
      std::array<int, 4> back{};
      for (int i = 0; i < 4; ++i) back[static_cast<std::size_t>(image(words[p], i))] = i;
      inverses[p] = from_images(back[0], back[1], back[2], back[3]).rank_;
    }
    return inverses;
  }
  static const std::array<std::uint8_t, 24> kWords;
  static const std::array<std::array<std::uint8_t, 24>, 24> kProducts;
  static const std::array<std::uint8_t, 24> kInverses;
  static const std::uint32_t kOddRanks;

  std::uint8_t rank_ = 0;
};

inline constexpr std::array<std::uint8_t, 24> Perm4::kWords = Perm4::make_words();
inline constexpr std::array<std::array<std::uint8_t, 24>, 24> Perm4::kProducts =
    Perm4::make_products();
inline constexpr std::array<std::uint8_t, 24> Perm4::kInverses = Perm4::make_inverses();
inline constexpr std::uint32_t Perm4::kOddRanks = Perm4::make_odd_ranks();

}  // namespace tripus::topology
