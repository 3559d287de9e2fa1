#include "energies/co_volume.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "geometry/ideal_tetrahedron.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/volume.hpp"

namespace tripus::energies {
namespace {

using geometry::kLanes;
using geometry::kPackedJacobian;
using topology::VertexKind;

/// Blocks evaluated in one call of the kernel: their gathered lengths stay in the first cache.
constexpr std::size_t kChunk = 32;

/// A harmless length for the lanes behind the last tetrahedron: a regular tetrahedron.
constexpr double kPaddingLength = 1.0;

constexpr double kPi = std::numbers::pi;

double gram_diagonal(VertexKind kind) {
  return kind == VertexKind::kHyperideal ? 1 : kind == VertexKind::kIdeal ? 0 : -1;
}

/// Edge classes, one for each ideal vertex, whose lengths fix all horospheres: in the graph of the
/// ideal vertices with these edges, every component has one cycle, and that is of odd length: a
/// loop, or a triangle. An edge with one ideal end counts as a loop there. Greedy, as in
/// Kruskal's algorithm; there are always enough, as the edges of a face with three ideal vertices
/// form such a cycle, and other faces have edges with one ideal end.
std::vector<std::uint32_t> horosphere_pins(const topology::Triangulation& triangulation,
                                           std::span<const topology::OrbifoldLink> links) {
  std::vector<std::size_t> parent(links.size());
  std::vector<bool> odd(links.size());    // against the parent: the sign of the horosphere's shift
  std::vector<bool> fixed(links.size());  // of a root: its component has its cycle
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = v;
  const auto root_of = [&](std::size_t v) {
    bool sign = false;
    for (; parent[v] != v; v = parent[v]) sign ^= odd[v];
    return std::pair(v, sign);
  };
  std::vector<std::uint32_t> pins;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const topology::EdgeCorner corner = triangulation.corners(e)[0];
    const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const std::size_t a = triangulation.vertex_class(corner.tetrahedron(), ends[0]);
    const std::size_t b = triangulation.vertex_class(corner.tetrahedron(), ends[1]);
    const bool ideal_a = links[a].kind == VertexKind::kIdeal;
    const bool ideal_b = links[b].kind == VertexKind::kIdeal;
    if (!ideal_a && !ideal_b) continue;
    const auto [root_a, sign_a] = root_of(ideal_a ? a : b);
    const auto [root_b, sign_b] = root_of(ideal_b ? b : a);
    if (root_a != root_b) {
      if (fixed[root_a] && fixed[root_b]) continue;
      parent[root_a] = root_b;
      odd[root_a] = sign_a == sign_b;  // the ends of an edge move by opposite amounts
      fixed[root_b] = fixed[root_a] || fixed[root_b];
    } else {
      const bool loop = !ideal_a || !ideal_b || sign_a == sign_b;
      if (fixed[root_a] || !loop) continue;
      fixed[root_a] = true;
    }
    pins.push_back(static_cast<std::uint32_t>(e));
  }
  return pins;
}

/// Whether these are the angles of a flat tetrahedron: the kernel gives it exactly four times 0 and
/// twice pi.
bool is_flat(const std::array<double, 6>& theta) {
  return std::count(theta.begin(), theta.end(), 0.0) == 4 &&
         std::count_if(theta.begin(), theta.end(), [](double a) { return a > 3.0; }) == 2;
}

/// The edge classes at the corners of block b, and how many of its lanes are tetrahedra.
struct Block {
  const std::uint32_t* edge;  // [lanes x 6]
  std::size_t lanes;

  Block(const topology::Triangulation& triangulation, std::size_t b)
      : edge(triangulation.edge_classes().data() + 6 * kLanes * b),
        lanes(std::min(kLanes, triangulation.tetrahedron_count() - kLanes * b)) {}

  void gather(std::span<const double> x, double padding, double* out) const {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t i = 0; i < 6; ++i) out[i * kLanes + lane] = x[edge[6 * lane + i]];
    for (std::size_t lane = lanes; lane < kLanes; ++lane)
      for (std::size_t i = 0; i < 6; ++i) out[i * kLanes + lane] = padding;
  }
  void scatter_add(const double* in, std::span<double> y) const {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t i = 0; i < 6; ++i) y[edge[6 * lane + i]] += in[i * kLanes + lane];
  }
};

/// A sum that carries its rounding errors along (Neumaier): totals over a million tetrahedra keep
/// their digits.
class Sum {
 public:
  void add(double x) {
    const double total = sum_ + x;
    lost_ += std::fabs(sum_) >= std::fabs(x) ? (sum_ - total) + x : (x - total) + sum_;
    sum_ = total;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

}  // namespace

CoVolume::CoVolume(const topology::Triangulation& triangulation,
                   std::span<const topology::ConeAngle> cone_angles)
    : triangulation_(triangulation),
      kernels_(geometry::batch_kernels()),
      links_(topology::orbifold_links(triangulation, cone_angles)) {
  for (const topology::ConeAngle& k : topology::completed(cone_angles, triangulation.edge_count()))
    cone_angles_.push_back(k.radians());
  const auto any = [&](VertexKind kind) {
    return std::ranges::any_of(links_, [kind](const auto& link) { return link.kind == kind; });
  };
  if (any(VertexKind::kFinite))
    form_ = Form::kFinite;
  else if (any(VertexKind::kIdeal))
    form_ = any(VertexKind::kHyperideal) ? Form::kMixed : Form::kIdeal;
  if (form_ == Form::kHyperideal) return;
  pins_ = horosphere_pins(triangulation, links_);
  if (form_ == Form::kIdeal) return;
  diagonal_.assign(geometry::block_count(triangulation.tetrahedron_count()) * 4 * kLanes, 1.0);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
    for (std::size_t v = 0; v < 4; ++v)
      diagonal_[(4 * (t / kLanes) + v) * kLanes + t % kLanes] =
          gram_diagonal(links_[triangulation.vertex_class(t, static_cast<int>(v))].kind);
}

CoVolume::CoVolume(const CoVolumeAt& at, std::vector<std::size_t> flat) : CoVolume(at.energy()) {
  held_ = std::move(flat);
  held_pi_.clear();
  for (const std::size_t t : held_) {
    const auto theta = at.dihedral_angles(t);
    std::size_t most = 0;
    for (std::size_t e = 1; e < 3; ++e)
      if (theta[e] + theta[5 - e] > theta[most] + theta[5 - most]) most = e;
    held_pi_.push_back(most);
  }
}

bool CoVolume::evaluate(std::span<const double> x, solver::Order order,
                        std::unique_ptr<solver::Evaluation>& into) const {
  auto& at = solver::reuse<CoVolumeAt>(into, *this);
  at.move_to(x, order);
  return at.is_defined();
}

CoVolumeAt CoVolume::at(std::span<const double> x, solver::Order order) const {
  CoVolumeAt result(*this);
  result.move_to(x, order);
  return result;
}

const ElementPattern& CoVolume::slots() const {
  return pattern_.get(
      [&] { return ElementPattern(dimension(), 6, triangulation_.edge_classes()); });
}

bool CoVolume::is_between_hyperideal(std::size_t e) const {
  const topology::EdgeCorner corner = triangulation_.corners(e)[0];
  return std::ranges::all_of(
      topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())], [&](int end) {
        return links_[triangulation_.vertex_class(corner.tetrahedron(), end)].kind ==
               VertexKind::kHyperideal;
      });
}

void CoVolumeAt::move_to(std::span<const double> x, solver::Order order) {
  const CoVolume& energy = *energy_;
  const bool second = order == solver::Order::kSecond;
  const topology::Triangulation& triangulation = energy.triangulation_;
  const std::size_t blocks = geometry::block_count(triangulation.tetrahedron_count());
  theta_ = 2 * x.size();
  jacobian_ = theta_ + blocks * 6 * kLanes;
  const std::size_t needed = jacobian_ + (second ? blocks * kPackedJacobian * kLanes : 0);
  if (needed > few_.size() && needed > many_.size()) many_ = std::vector<double>(needed);
  std::ranges::copy(x, memory());
  is_defined_ = std::all_of(x.begin(), x.end(), [](double l) { return std::isfinite(l); });
  if (!is_defined_) return;

  const std::span<double> gradient(memory() + x.size(), x.size());
  std::transform(energy.cone_angles_.begin(), energy.cone_angles_.end(), gradient.begin(),
                 [](double k) { return -k; });
  flat_count_ = 0;
  alignas(64) double lengths[kChunk * 6 * kLanes];
  for (std::size_t begin = 0; begin < blocks; begin += kChunk) {
    const std::size_t count = std::min(kChunk, blocks - begin);
    for (std::size_t b = 0; b < count; ++b)
      Block(triangulation, begin + b).gather(x, kPaddingLength, lengths + 6 * kLanes * b);
    is_defined_ = angles(begin, count, lengths, second);
    if (!is_defined_) return;
    if (!energy.held_.empty()) flatten(begin, begin + count, second);
    for (std::size_t b = 0; b < count; ++b)
      Block(triangulation, begin + b).scatter_add(theta_block(begin + b), gradient);
  }
}

/// Angles, and Jacobians if asked for, of blocks whose lengths have been gathered.
bool CoVolumeAt::angles(std::size_t first_block, std::size_t count, const double* lengths,
                        bool second_derivatives) {
  double* theta = theta_block(first_block);
  double* jacobian = second_derivatives ? jacobian_block(first_block) : nullptr;
  using Form = CoVolume::Form;
  switch (energy_->form_) {
    case Form::kHyperideal:
      flat_count_ += energy_->kernels_.angles(count, lengths, theta, jacobian);
      return true;
    case Form::kIdeal:
      flat_count_ += energy_->kernels_.ideal_angles(count, lengths, theta, jacobian);
      return true;
    case Form::kMixed:
      flat_count_ += energy_->kernels_.mixed_angles(
          count, lengths, energy_->diagonal_.data() + 4 * kLanes * first_block, theta, jacobian);
      return true;
    case Form::kFinite:
      break;
  }
  return finite_angles(first_block, count, lengths, second_derivatives);
}

/// One by one; false if some tetrahedron is not a true one.
bool CoVolumeAt::finite_angles(std::size_t first_block, std::size_t count, const double* lengths,
                               bool second_derivatives) {
  const std::size_t last =
      std::min(kLanes * (first_block + count), energy_->triangulation_.tetrahedron_count());
  for (std::size_t t = kLanes * first_block; t < last; ++t) {
    const std::size_t block = t / kLanes, lane = t % kLanes;
    std::array<double, 6> l, angle;
    std::array<double, 4> d;
    std::array<double, 36> jacobian;
    for (std::size_t e = 0; e < 6; ++e)
      l[e] = lengths[(6 * (block - first_block) + e) * kLanes + lane];
    for (std::size_t v = 0; v < 4; ++v) d[v] = energy_->diagonal_[(4 * block + v) * kLanes + lane];
    if (!geometry::general_dihedral_angles(
            l, d, angle, second_derivatives ? std::span<double>(jacobian) : std::span<double>()))
      return false;
    for (std::size_t e = 0; e < 6; ++e) theta_block(block)[e * kLanes + lane] = angle[e];
    if (!second_derivatives) continue;
    double* packed = jacobian_block(block) + lane;
    for (std::size_t i = 0, q = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j, ++q) packed[q * kLanes] = jacobian[6 * i + j];
  }
  return true;
}

/// Overwrites what the kernel found for those tetrahedra of the blocks that are held flat.
void CoVolumeAt::flatten(std::size_t first_block, std::size_t last_block, bool second_derivatives) {
  const std::vector<std::size_t>& held = energy_->held_;
  auto k = static_cast<std::size_t>(
      std::lower_bound(held.begin(), held.end(), kLanes * first_block) - held.begin());
  for (; k < held.size() && held[k] < kLanes * last_block; ++k) {
    const std::size_t block = held[k] / kLanes, lane = held[k] % kLanes;
    if (!is_flat(dihedral_angles(held[k]))) ++flat_count_;
    for (std::size_t e = 0; e < 6; ++e)
      theta_block(block)[e * kLanes + lane] = std::min(e, 5 - e) == energy_->held_pi_[k] ? kPi : 0;
    if (!second_derivatives) continue;
    for (std::size_t q = 0; q < kPackedJacobian; ++q) jacobian_block(block)[q * kLanes + lane] = 0;
  }
}

void CoVolumeAt::hessian_values(std::span<double> values) const {
  const topology::Triangulation& triangulation = energy_->triangulation_;
  const ElementPattern& slots = energy_->slots();
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::size_t q = 0;
    for (int i = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j, ++q) {
        // Two different corners on one edge class meet in its diagonal entry from both sides.
        const bool twice =
            i != j && triangulation.edge_class(t, i) == triangulation.edge_class(t, j);
        const double entry = jacobian_entry(t, q);
        values[static_cast<std::size_t>(slots.slot(t, q))] += twice ? 2 * entry : entry;
      }
    }
  }
}

bool CoVolumeAt::dense_hessian(std::span<double> lower) const {
  const std::uint32_t* edge = energy_->triangulation_.edge_classes().data();
  const std::size_t n = energy_->dimension();
  std::fill(lower.begin(), lower.end(), 0.0);
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t, edge += 6) {
    std::size_t q = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      lower[edge[i] * (n + 1)] += jacobian_entry(t, q++);
      for (std::size_t j = i + 1; j < 6; ++j, ++q) {
        const double entry = jacobian_entry(t, q);
        const std::size_t a = edge[i], b = edge[j];
        // Two different corners on one edge class meet in its diagonal entry from both sides.
        lower[a < b ? a * n + b : b * n + a] += a == b ? 2 * entry : entry;
      }
    }
  }
  return true;
}

void CoVolumeAt::hessian_times(std::span<const double> v, std::span<double> Hv) const {
  const topology::Triangulation& triangulation = energy_->triangulation_;
  const auto jacobian_times = energy_->kernels_.jacobian_times;
  std::fill(Hv.begin(), Hv.end(), 0.0);
  alignas(64) double in[6 * kLanes], out[6 * kLanes];
  const std::size_t blocks = geometry::block_count(triangulation.tetrahedron_count());
  for (std::size_t b = 0; b < blocks; ++b) {
    const Block block(triangulation, b);
    block.gather(v, 0.0, in);
    jacobian_times(jacobian_block(b), in, out);
    block.scatter_add(out, Hv);
  }
}

void CoVolumeAt::hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const {
  std::fill(blocks.begin(), blocks.end(), 0.0);
  if (block_size == 1) {
    const std::uint32_t* edge = energy_->triangulation_.edge_classes().data();
    for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t, edge += 6) {
      std::size_t q = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        blocks[edge[i]] += jacobian_entry(t, q++);
        for (std::size_t j = i + 1; j < 6; ++j, ++q)
          if (edge[i] == edge[j]) blocks[edge[i]] += 2 * jacobian_entry(t, q);
      }
    }
    return;
  }
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    std::size_t q = 0;
    for (int i = 0; i < 6; ++i) {
      const std::size_t a = energy_->triangulation_.edge_class(t, i);
      for (int j = i; j < 6; ++j, ++q) {
        const std::size_t b = energy_->triangulation_.edge_class(t, j);
        if (a / block_size != b / block_size) continue;
        const double entry = jacobian_entry(t, q);
        double* block = blocks.data() + (a / block_size) * block_size * block_size;
        block[(a % block_size) * block_size + b % block_size] += entry;
        if (i != j) block[(b % block_size) * block_size + a % block_size] += entry;
      }
    }
  }
}

std::array<double, 6> CoVolumeAt::dihedral_angles(std::size_t t) const {
  std::array<double, 6> theta;
  const double* block = theta_block(t / kLanes);
  for (std::size_t i = 0; i < 6; ++i) theta[i] = block[i * kLanes + t % kLanes];
  return theta;
}

std::vector<std::size_t> CoVolumeAt::flat_tetrahedra() const {
  std::vector<std::size_t> flat;
  if (flat_count_ == 0) return flat;
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    if (is_flat(dihedral_angles(t))) flat.push_back(t);
  }
  return flat;
}

double CoVolumeAt::volume_of(std::span<const double, 6> theta) const {
  return energy_->form_ == CoVolume::Form::kIdeal ? geometry::ideal_volume(theta)
                                                  : geometry::volume(theta);
}

double CoVolumeAt::volume() const {
  Sum sum;
  std::array<double, 6> latest{};
  double latest_volume = 0;
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    const std::array<double, 6> theta = dihedral_angles(t);
    // Where all lengths are equal, as at the start, all tetrahedra are.
    if (t == 0 || theta != latest) latest_volume = volume_of(theta);
    latest = theta;
    sum.add(latest_volume);
  }
  return sum.value();
}

double CoVolumeAt::convexity_bound() const {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  double largest_inverse = 0;
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    if (flat_count_ != 0 && is_flat(dihedral_angles(t))) continue;
    Matrix jacobian;
    Eigen::Index q = 0;
    for (Eigen::Index i = 0; i < 6; ++i)
      for (Eigen::Index j = i; j < 6; ++j, ++q)
        jacobian(i, j) = jacobian(j, i) = jacobian_entry(t, static_cast<std::size_t>(q));
    const Eigen::LLT<Matrix> factor(jacobian);
    if (factor.info() != Eigen::Success) return 0;
    const Matrix inverse = factor.solve(Matrix::Identity());
    largest_inverse = std::max(largest_inverse, inverse.norm());
  }
  std::size_t least_valence = energy_->triangulation_.valence(0);
  for (std::size_t e = 1; e < energy_->dimension(); ++e)
    least_valence = std::min(least_valence, energy_->triangulation_.valence(e));
  return largest_inverse > 0 ? static_cast<double>(least_valence) / largest_inverse : 0;
}

double CoVolumeAt::value() const {
  const std::span<const double> x = lengths();
  Sum sum;
  for (std::size_t t = 0; t < energy_->triangulation_.tetrahedron_count(); ++t) {
    const auto theta = dihedral_angles(t);
    sum.add(2 * volume_of(theta));
    for (int i = 0; i < 6; ++i)
      sum.add(theta[static_cast<std::size_t>(i)] * x[energy_->triangulation_.edge_class(t, i)]);
  }
  for (std::size_t e = 0; e < x.size(); ++e) sum.add(-energy_->cone_angles_[e] * x[e]);
  return sum.value();
}

}  // namespace tripus::energies
