#include "embedding/wide_holonomy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/QR>

#include "embedding/detail/wide_map.hpp"

namespace tripus::embedding {

using detail::WideComplex;
using detail::WideMap;
using detail::WideNumber;
using geometry::Complex;

namespace {

constexpr std::size_t kMostGenerators = 300;
constexpr int kMostSteps = 30;
constexpr double kRelatorsHold = 1e-50;

/// (h, b; c, -h): how a map of determinant 1 may be moved.
using Direction = std::array<WideComplex, 3>;

/// R = +-1 up to rounding, as the direction from the identity.
Direction direction_of(const WideMap& relator) {
  const auto& [a, b, c, d] = relator.m;
  const WideNumber sign = a.re + d.re < 0 ? -1 : 1;
  return {(a - d) * (sign / 2), b * sign, c * sign};
}

double size_of(const Direction& direction) {
  double largest = 0;
  for (const WideComplex& each : direction)
    largest = std::max(largest, static_cast<double>(sqrt(each.square())));
  return largest;
}

/// What P moves a direction to: P (h, b; c, -h) P^-1 is linear in (h, b, c).
Eigen::Matrix3cd conjugation(const geometry::MoebiusMap& map) {
  const auto& [a, b, c, d, reverses] = map;
  Eigen::Matrix3cd result;
  result << a * d + b * c, -a * c, b * d,  //
      -2.0 * a * b, a * a, -b * b,         //
      2.0 * c * d, -c * c, d * d;
  return result;
}

}  // namespace

struct WideHolonomy::Generators {
  std::vector<WideMap> maps, inverses;

  const WideMap& of(topology::Letter letter) const {
    return (letter > 0 ? maps : inverses)[topology::generator_of(letter)];
  }
  WideMap product_of(const topology::Word& word) const {
    WideMap result = detail::widened({});
    for (const topology::Letter letter : word) result = detail::product(result, of(letter));
    return result;
  }
  void invert() {
    inverses.clear();
    for (const WideMap& map : maps) inverses.push_back(detail::inverse(map));
  }
  std::vector<Direction> missing(const std::vector<topology::Word>& relators) const {
    std::vector<Direction> result;
    for (const topology::Word& relator : relators)
      result.push_back(direction_of(product_of(relator)));
    return result;
  }

  /// Moves each generator g to g (1 + x_g), where the x are the shortest that take the relators to
  /// the identity to first order: a letter g behind P adds (P g) x (P g)^-1, and g^-1 takes away
  /// P x P^-1.
  void step(const std::vector<topology::Word>& relators, const std::vector<Direction>& missing) {
    const auto rows = static_cast<Eigen::Index>(3 * relators.size());
    const auto columns = static_cast<Eigen::Index>(3 * maps.size());
    Eigen::MatrixXcd moves = Eigen::MatrixXcd::Zero(rows, columns);
    Eigen::VectorXcd wanted(rows);
    double scale = 0;  // what is missing may be smaller than doubles are
    for (const Direction& each : missing) scale = std::max(scale, size_of(each));
    for (std::size_t r = 0; r < relators.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(3 * r);
      WideMap before = detail::widened({});
      for (const topology::Letter letter : relators[r]) {
        const WideMap behind = detail::product(before, of(letter));
        moves.block<3, 3>(row, static_cast<Eigen::Index>(3 * topology::generator_of(letter))) +=
            letter > 0 ? conjugation(detail::rounded(behind))
                       : Eigen::Matrix3cd(-conjugation(detail::rounded(before)));
        before = behind;
      }
      for (std::size_t k = 0; k < 3; ++k)
        wanted[row + static_cast<Eigen::Index>(k)] =
            -(missing[r][k] * (WideNumber(1) / scale)).rounded();
      // The same weight for relators far away.
      const double size = moves.middleRows<3>(row).norm();
      if (size == 0) continue;  // an empty relator
      moves.middleRows<3>(row) /= size;
      wanted.segment<3>(row) /= size;
    }
    const Eigen::VectorXcd found = moves.completeOrthogonalDecomposition().solve(wanted);
    for (std::size_t g = 0; g < maps.size(); ++g) {
      std::array<WideComplex, 3> x;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = WideComplex::of(found[static_cast<Eigen::Index>(3 * g + k)]) * WideNumber(scale);
      const WideComplex one = WideComplex::of(1);
      maps[g] =
          detail::on_group(detail::product(maps[g], {{one + x[0], x[1], x[2], one - x[0]}, false}));
    }
    invert();
  }
};

WideHolonomy::WideHolonomy(const Holonomy& holonomy) : generators_(std::make_unique<Generators>()) {
  for (const geometry::MoebiusMap& map : holonomy.moebius)
    generators_->maps.push_back(detail::widened(map));
  generators_->invert();
  if (holonomy.orientable && generators_->maps.size() <= kMostGenerators)
    refine(holonomy.group.presentation.relators);
}

void WideHolonomy::refine(const std::vector<topology::Word>& relators) {
  const auto largest = [](const std::vector<Direction>& missing) {
    double result = 0;
    for (const Direction& each : missing) result = std::max(result, size_of(each));
    return result;
  };
  std::vector<Direction> missing = generators_->missing(relators);
  defect_ = largest(missing);
  for (int n = 0; n < kMostSteps && defect_ > kRelatorsHold; ++n) {
    Generators next = *generators_;
    next.step(relators, missing);
    std::vector<Direction> rest = next.missing(relators);
    const double defect = largest(rest);
    if (!(defect < defect_)) return;
    *generators_ = std::move(next);
    missing = std::move(rest);
    defect_ = defect;
  }
}

WideHolonomy::~WideHolonomy() = default;

LongMatrix4 WideHolonomy::isometry_of(const topology::Word& word) const {
  return detail::to_matrix<long double>(generators_->product_of(word));
}

}  // namespace tripus::embedding
