#include "energies/volume_in_angles.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/error.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"

namespace tripus::energies {
namespace {

constexpr std::size_t kLocal = 12;  // at most two variables a corner

std::uint32_t flat_corner(topology::EdgeCorner corner) {
  return static_cast<std::uint32_t>(6 * corner.tetrahedron()) +
         static_cast<std::uint32_t>(corner.edge());
}

std::span<const double, 6> six(const std::vector<double>& values, std::size_t t) {
  return std::span<const double, 6>(values.data() + 6 * t, 6);
}

}  // namespace

VolumeInAngles::VolumeInAngles(const topology::Triangulation& triangulation,
                               std::span<const double> interior)
    : triangulation_(triangulation), interior_(interior.begin(), interior.end()) {
  const std::size_t corners = 6 * triangulation.tetrahedron_count();
  if (interior.size() != corners) {
    throw InvalidInput("there are " + std::to_string(interior.size()) + " dihedral angles for " +
                       std::to_string(corners) + " corners; give one for each");
  }
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<double, 6> l;
    if (!geometry::lengths_from_angles(six(interior_, t), l)) {
      throw InvalidInput("the angles of tetrahedron " + std::to_string(t) +
                         " are not those of a truncated tetrahedron; they must be greater than 0 "
                         "and sum to less than pi at every vertex");
    }
  }
  variables_.assign(2 * corners, kNoVariable);
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const auto around = triangulation.corners(e);
    for (std::size_t k = 0; k + 1 < around.size(); ++k) {
      const auto variable = static_cast<std::uint32_t>(first_.size());
      const std::uint32_t c = flat_corner(around[k]), d = flat_corner(around[k + 1]);
      first_.push_back(c);
      second_.push_back(d);
      variables_[kLocal * (c / 6) + c % 6] = variable;
      variables_[kLocal * (d / 6) + 6 + d % 6] = variable;
    }
  }
}

bool VolumeInAngles::evaluate(std::span<const double> y, solver::Order order,
                              std::unique_ptr<solver::Evaluation>& into) const {
  return solver::reuse<VolumeInAnglesAt>(into, *this).move_to(y, order);
}

VolumeInAnglesAt VolumeInAngles::at(std::span<const double> y, solver::Order order) const {
  VolumeInAnglesAt result(*this);
  result.move_to(y, order);
  return result;
}

const ElementPattern& VolumeInAngles::slots() const {
  return pattern_.get([&] { return ElementPattern(dimension(), kLocal, variables_); });
}

VolumeInAnglesAt::VolumeInAnglesAt(const VolumeInAngles& energy)
    : energy_(&energy),
      gradient_(energy.dimension()),
      theta_(energy.interior_.size()),
      length_(energy.interior_.size()) {}

bool VolumeInAnglesAt::move_to(std::span<const double> y, solver::Order order) {
  const std::vector<std::uint32_t>&first = energy_->first_, &second = energy_->second_;
  theta_ = energy_->interior_;
  for (std::size_t v = 0; v < y.size(); ++v) {
    theta_[first[v]] += y[v];
    theta_[second[v]] -= y[v];
  }
  const std::size_t tetrahedra = theta_.size() / 6;
  if (order == solver::Order::kSecond) inverse_.resize(36 * tetrahedra);
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    const std::span<double, 6> l(length_.data() + 6 * t, 6);
    if (!geometry::lengths_from_angles(six(theta_, t), l)) return false;
    if (order == solver::Order::kSecond) {
      using Matrix = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
      Matrix jacobian;
      std::array<double, 6> angles;
      if (geometry::extended_dihedral_angles(l, angles, {jacobian.data(), 36}) !=
          geometry::TetrahedronKind::kTruncated)
        return false;
      Eigen::Map<Matrix>(inverse_.data() + 36 * t) = jacobian.llt().solve(Matrix::Identity());
    }
  }
  for (std::size_t v = 0; v < y.size(); ++v) gradient_[v] = length_[first[v]] - length_[second[v]];
  return true;
}

double VolumeInAnglesAt::value() const {
  double value = 0;
  for (std::size_t t = 0; 6 * t < theta_.size(); ++t) value -= 2 * geometry::volume(six(theta_, t));
  return value;
}

template <class Add>
void VolumeInAnglesAt::for_entries(Add&& add) const {
  // df = sum l d theta, so the Hessian in the angles is d l / d theta.
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    const std::uint32_t* variable = energy_->variables_.data() + kLocal * t;
    const double* inverse = inverse_.data() + 36 * t;
    for (std::size_t i = 0; i < kLocal; ++i) {
      if (variable[i] == kNoVariable) continue;
      for (std::size_t j = 0; j < kLocal; ++j) {
        if (variable[j] == kNoVariable) continue;
        const double entry = inverse[6 * (i % 6) + j % 6];
        add(t, i, j, (i < 6) == (j < 6) ? entry : -entry);
      }
    }
  }
}

void VolumeInAnglesAt::hessian_values(std::span<double> values) const {
  const ElementPattern& slots = energy_->slots();
  std::fill(values.begin(), values.end(), 0.0);
  for_entries([&](std::size_t t, std::size_t i, std::size_t j, double entry) {
    const bool same = energy_->variables_[kLocal * t + i] == energy_->variables_[kLocal * t + j];
    if (i > j && !same) return;  // the lower triangle once; a shared variable from both sides
    const std::size_t a = std::min(i, j), b = std::max(i, j);
    const std::size_t pair = a * kLocal - a * (a - 1) / 2 + (b - a);
    values[static_cast<std::size_t>(slots.slot(t, pair))] += entry;
  });
}

void VolumeInAnglesAt::hessian_times(std::span<const double> v, std::span<double> Hv) const {
  std::fill(Hv.begin(), Hv.end(), 0.0);
  for_entries([&](std::size_t t, std::size_t i, std::size_t j, double entry) {
    Hv[energy_->variables_[kLocal * t + i]] += entry * v[energy_->variables_[kLocal * t + j]];
  });
}

void VolumeInAnglesAt::hessian_diagonal_blocks(std::size_t block_size,
                                               std::span<double> blocks) const {
  std::fill(blocks.begin(), blocks.end(), 0.0);
  for_entries([&](std::size_t t, std::size_t i, std::size_t j, double entry) {
    const std::size_t a = energy_->variables_[kLocal * t + i],
                      b = energy_->variables_[kLocal * t + j];
    if (a / block_size != b / block_size) return;
    blocks[(a / block_size * block_size + a % block_size) * block_size + b % block_size] += entry;
  });
}

std::vector<double> VolumeInAnglesAt::mean_edge_lengths() const {
  std::vector<double> mean(energy_->triangulation_.edge_count());
  for (std::size_t e = 0; e < mean.size(); ++e) {
    const auto around = energy_->triangulation_.corners(e);
    for (const auto corner : around) mean[e] += length_[flat_corner(corner)];
    mean[e] /= static_cast<double>(around.size());
  }
  return mean;
}

}  // namespace tripus::energies
