#include "parameterise/deck_group.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "geometry/hyperbolic_space.hpp"

namespace tripus::parameterise {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Heights (cosh of the distance) are put into boxes of this width in their logarithm.
constexpr double kBox = 1e-3;
/// Places nearer than this, relative to their height, are one. Of different cells the centres are
/// farther apart, by the least translation over the height; what rounding moves by more is found by
/// walking home.
constexpr double kSamePlace = 1e-9;
/// Poles of truncations of one cell are far apart; a vector found by least squares is off by less.
constexpr double kSamePole = 1e-3;
/// Beyond, at a distance of 18, a product loses more digits than there are: its rounding is that of
/// long doubles times the heights of both factors.
constexpr double kHighest = 3e7;

std::int64_t box_of(long double height) {
  return static_cast<std::int64_t>(std::floor(std::log(height) / kBox));
}

LongVector4 on_long_hyperboloid(LongVector4 x) {
  x[3] = std::sqrt(1 + x.head<3>().squaredNorm());
  return x;
}

/// geometry::lorentz_inverse.
LongMatrix4 long_inverse(const LongMatrix4& isometry) {
  const LongVector4 signs(1, 1, 1, -1);
  return signs.asDiagonal() * isometry.transpose() * signs.asDiagonal();
}

}  // namespace

DeckGroup::DeckGroup(const embedding::Embedding& embedding,
                     const topology::Triangulation& triangulation,
                     const embedding::Holonomy& holonomy, const std::vector<Matrix4>& places)
    : embedding_(embedding),
      triangulation_(triangulation),
      holonomy_(holonomy),
      places_(places),
      generators_(holonomy) {
  of_word({});
}

std::uint32_t DeckGroup::find(const LongVector4& place) const {
  const std::int64_t box = box_of(place[3]);
  for (std::int64_t b = box - 1; b <= box + 1; ++b) {
    const auto [begin, end] = by_height_.equal_range(b);
    for (auto each = begin; each != end; ++each)
      if ((long_matrices_[each->second].col(3) - place).cwiseAbs().maxCoeff() <=
          kSamePlace * place[3])
        return each->second;
  }
  return kNone;
}

std::uint32_t DeckGroup::of_word(const topology::Word& word) {
  const LongMatrix4 matrix = generators_.isometry_of(word);
  const std::uint32_t known = find(matrix.col(3));
  if (known != kNone) return known;
  matrices_.push_back(matrix.cast<double>());
  long_matrices_.push_back(matrix);
  words_.push_back(word);
  const auto number = static_cast<std::uint32_t>(matrices_.size() - 1);
  by_height_.emplace(box_of(matrix(3, 3)), number);
  return number;
}

/// From tetrahedron 0 cell by cell, each time through the face that parts it from the place the
/// most, to the cell that holds it.
DeckGroup::Way DeckGroup::walk(const LongVector4& place) const {
  constexpr double kInside = 1e-9;
  constexpr int kMostCells = 100'000;
  topology::Word word;
  LongVector4 y = place;
  std::size_t t = 0;
  for (int n = 0; n < kMostCells; ++n) {
    std::size_t face = 4;
    long double most = kInside * y[3];
    for (std::size_t f = 0; f < 4; ++f) {
      const LongVector4 normal = embedding_.tetrahedra[t].faces[f].cast<long double>();
      const long double beyond = y.head<3>().dot(normal.head<3>()) - y[3] * normal[3];
      if (beyond > most) {
        most = beyond;
        face = f;
      }
    }
    if (face == 4) break;
    y = on_long_hyperboloid(long_inverse(embedding_.face_pairings[t][face].cast<long double>()) *
                            y);
    const topology::Letter letter = holonomy_.group.face_letters[4 * t + face];
    if (letter != 0) {
      if (!word.empty() && word.back() == -letter)
        word.pop_back();
      else
        word.push_back(letter);
    }
    t = triangulation_.gluings().neighbour(t, static_cast<int>(face));
  }
  return {word, t, y};
}

std::uint32_t DeckGroup::of_place(const Vector4& point) {
  LongVector4 y = point.cast<long double>();
  std::uint32_t element = of_word(walk(y).word);
  y = long_inverse(long_matrices_[element]) * y;
  for (std::uint32_t nearer = 0;; element = product(element, nearer)) {
    long double least = y[3] * (1 - 1e-9L);
    nearer = 0;
    for (const std::uint32_t each : around_edges()) {
      const LongMatrix4& matrix = long_matrices_[each];
      const long double height =
          matrix(3, 3) * y[3] - matrix.col(3).head<3>().dot(y.head<3>());  // -<g 0, y>
      if (height >= least) continue;
      least = height;
      nearer = each;
    }
    if (nearer == 0) return element;
    y = on_long_hyperboloid(long_inverse(long_matrices_[nearer]) * y);
  }
}

const std::vector<std::uint32_t>& DeckGroup::around_edges() {
  if (!around_edges_.empty()) return around_edges_;
  std::set<std::uint32_t> found;
  for (const topology::Word& relator : holonomy_.group.presentation.relators)
    for (std::size_t first = 0; first < relator.size(); ++first) {
      topology::Word part;
      for (std::size_t n = 0; n + 1 < relator.size(); ++n) {
        part.push_back(relator[(first + n) % relator.size()]);
        found.insert(of_word(part));
      }
    }
  found.erase(0);
  return around_edges_ = {found.begin(), found.end()};
}

std::optional<ExactPole> DeckGroup::exact_pole(const Vector4& pole) {
  // The point of the plane that is nearest to the origin, and the cell there.
  const Vector4 foot = geometry::on_hyperboloid((geometry::origin() + pole[3] * pole) /
                                                std::sqrt(1 + pole[3] * pole[3]));
  const Way way = walk(foot.cast<long double>());
  const std::uint32_t element = of_word(way.word);
  const Matrix4 domain = geometry::lorentz_inverse(matrices_[element] * places_[way.tetrahedron]);
  const Vector4 here = domain * pole;
  for (const Vector4& vertex : embedding_.tetrahedra[way.tetrahedron].vertices)
    if ((vertex - here).norm() < kSamePole * vertex.norm())
      return ExactPole{element, places_[way.tetrahedron] * vertex};
  return std::nullopt;
}

std::uint32_t DeckGroup::of_near(const LongVector4& near) {
  const LongVector4 place = on_long_hyperboloid(near);
  if (!(place[3] < kHighest))
    throw Unsupported(
        "deck transformations of this solid take points so far that long doubles do not hold them; "
        "its triangulation has too large a fundamental domain");
  const std::uint32_t known = find(place);
  if (known != kNone) return known;
  const Way way = walk(place);
  if (way.tetrahedron != 0 || way.place.head<3>().norm() > 1e-3)
    throw InternalError("a deck transformation does not lead to a cell of the universal cover");
  return of_word(way.word);
}

std::uint32_t DeckGroup::product(std::uint32_t first, std::uint32_t second) {
  if (first == 0) return second;
  if (second == 0) return first;
  const std::uint64_t key = std::uint64_t{first} << 32 | second;
  const auto known = products_.find(key);
  if (known != products_.end()) return known->second;
  const std::uint32_t product = of_near(long_matrices_[first] * long_matrices_[second].col(3));
  products_.emplace(key, product);
  return product;
}

std::uint32_t DeckGroup::conjugate(std::uint32_t from, std::uint32_t element, std::uint32_t to) {
  if (from == 0) return product(element, to);
  const LongVector4 place = long_matrices_[element] * long_matrices_[to].col(3);
  return of_near(long_inverse(long_matrices_[from]) * place);
}

// The sum of cosh(distance) is convex, and least in one point when it is the sum of the others,
// scaled to the hyperboloid; by Gauss and Seidel.
std::vector<std::uint32_t> DeckGroup::better_frames(std::span<const Link> links,
                                                    std::size_t frames) {
  constexpr int kRounds = 30;
  std::vector<Vector4> points(frames, geometry::origin());
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t n = 0; n < links.size();) {
      const std::uint32_t frame = links[n].from;
      Vector4 sum = Vector4::Zero();
      for (; n < links.size() && links[n].from == frame; ++n)
        sum += matrices_[links[n].element] * points[links[n].to];
      points[frame] = geometry::on_hyperboloid(
          sum / std::sqrt(std::max(-geometry::lorentz_product(sum, sum), 1.0)));
    }
  std::vector<std::uint32_t> change;
  for (const Vector4& point : points) change.push_back(of_place(point));
  return change;
}

std::uint32_t DeckGroup::inverse(std::uint32_t element) {
  if (element == 0) return 0;
  const auto known = inverses_.find(element);
  if (known != inverses_.end()) return known->second;
  const std::uint32_t inverse = of_near(long_inverse(long_matrices_[element]).col(3));
  inverses_.emplace(element, inverse);
  inverses_.emplace(inverse, element);
  return inverse;
}

double DeckGroup::size(std::uint32_t element) const {
  return element == 0 ? 0 : std::acosh(std::max(1.0, matrices_[element](3, 3)));
}

bool DeckGroup::can_hold_product(std::uint32_t first, std::uint32_t second) const {
  return size(first) + size(second) < std::acosh(kHighest);
}

std::uint32_t DeckGroup::of_letter(topology::Letter letter) {
  return letter == 0 ? 0 : of_word({letter});
}

embedding::Embedding mirrored(const embedding::Embedding& embedding) {
  const Vector4 signs(-1, 1, 1, 1);
  embedding::Embedding result = embedding;
  for (auto& tetrahedron : result.tetrahedra) {
    for (Vector4& vertex : tetrahedron.vertices) vertex = signs.asDiagonal() * vertex;
    for (Vector4& face : tetrahedron.faces) face = signs.asDiagonal() * face;
  }
  for (auto& pairings : result.face_pairings)
    for (Matrix4& pairing : pairings)
      pairing = (signs.asDiagonal() * pairing * signs.asDiagonal()).eval();
  return result;
}

}  // namespace tripus::parameterise
