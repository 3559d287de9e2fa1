#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "embedding/wide_holonomy.hpp"
#include "topology/simplify/carry_back.hpp"

namespace tripus::parameterise {

using embedding::LongMatrix4;
using embedding::Matrix4;
using embedding::Vector4;
using LongVector4 = Eigen::Matrix<long double, 4, 1>;

/// A plane of the universal cover's boundary: an element times the pole of a truncation in the
/// fundamental domain.
struct ExactPole {
  std::uint32_t element = 0;
  Vector4 pole;
};

/// Deck transformations of a hyperbolic manifold's universal cover, each known by one number, as a
/// reduced word in the generators of its holonomy and as a Lorentz matrix that is the product of
/// that word in a hundred digits, of generators that satisfy the relators to fifty. A product of
/// two numbers is looked up by where it takes the centre of tetrahedron 0: deck transformations
/// have no fixed points, so that this tells them apart. What is not known yet gets its word by
/// walking home from there through the cells. So matrices do not inherit the rounding of the
/// products that led to them, however many these are.
class DeckGroup final : public topology::NumberedGroup {
 public:
  /// Keeps references to all four. `places` are those of the tetrahedra in the domain. The holonomy
  /// is of the embedding; the manifold is orientable.
  DeckGroup(const embedding::Embedding& embedding, const topology::Triangulation& triangulation,
            const embedding::Holonomy& holonomy, const std::vector<Matrix4>& places);

  /// Throws Unsupported if the product takes the centre so far away, some 18, that long doubles do
  /// not tell where.
  std::uint32_t product(std::uint32_t first, std::uint32_t second) override;
  std::uint32_t inverse(std::uint32_t element) override;
  /// The distance by which the centre of tetrahedron 0 is moved.
  double size(std::uint32_t element) const override;
  bool can_hold_product(std::uint32_t first, std::uint32_t second) const override;
  std::uint32_t conjugate(std::uint32_t from, std::uint32_t element, std::uint32_t to) override;
  /// Gives every frame a point, such that the sum of cosh(distance) along the links is less, and
  /// takes the copies of the domain in which the points lie.
  std::vector<std::uint32_t> better_frames(std::span<const Link> links,
                                           std::size_t frames) override;
  std::uint32_t of_letter(topology::Letter letter);
  /// The element that takes the fundamental domain to its copy in which this point lies, or, where
  /// steps to copies that share an edge with it lead there, to one whose centre is nearer to the
  /// point: an approximation to Dirichlet's domain, whose copies are as near as can be.
  std::uint32_t of_place(const Vector4& point);

  /// The truncation plane that this pole is, up to rounding; nothing if it is none.
  std::optional<ExactPole> exact_pole(const Vector4& pole);

  std::size_t size() const { return matrices_.size(); }  ///< elements known so far
  const Matrix4& matrix(std::uint32_t element) const { return matrices_[element]; }
  /// The same, to all digits of a long double.
  const LongMatrix4& long_matrix(std::uint32_t element) const { return long_matrices_[element]; }
  /// [size] all of them; the first is the identity.
  const std::vector<Matrix4>& matrices() const { return matrices_; }
  const topology::Word& word(std::uint32_t element) const { return words_[element]; }

 private:
  std::uint32_t of_near(const LongVector4& near);
  /// Elements that take the domain to a copy which has an edge with it in common.
  const std::vector<std::uint32_t>& around_edges();
  std::uint32_t of_word(const topology::Word& word);
  std::uint32_t find(const LongVector4& place) const;
  /// The letters on the way, and where it ends: the tetrahedron, and the place in its frame.
  struct Way {
    topology::Word word;
    std::size_t tetrahedron;
    LongVector4 place;
  };
  Way walk(const LongVector4& place) const;

  const embedding::Embedding& embedding_;
  const topology::Triangulation& triangulation_;
  const embedding::Holonomy& holonomy_;
  const std::vector<Matrix4>& places_;
  embedding::WideHolonomy generators_;
  std::vector<Matrix4> matrices_;
  std::vector<LongMatrix4> long_matrices_;
  std::vector<topology::Word> words_;
  std::unordered_multimap<std::int64_t, std::uint32_t> by_height_;
  std::vector<std::uint32_t> around_edges_;  ///< found when they are needed
  std::unordered_map<std::uint64_t, std::uint32_t> products_;
  std::unordered_map<std::uint32_t, std::uint32_t> inverses_;
};

/// The embedding in the mirror, for a manifold whose orientation is the other one.
embedding::Embedding mirrored(const embedding::Embedding& embedding);

}  // namespace tripus::parameterise
