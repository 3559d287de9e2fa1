// The harmonic map by Ceres: nonlinear least squares on a product of hyperboloids and planes.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include "geometry/boost.hpp"
#include "parameterise/harmonic_map.hpp"
#include "solver/run.hpp"

namespace tripus::parameterise {
namespace {

using geometry::Vector3;

/// Beyond so many points a factorisation fills in too much; conjugate gradients on the normal
/// equations then.
constexpr std::size_t kDirect = 60'000;
/// Where the balance takes over, in parts of the first gradient. Gauss-Newton's method converges
/// linearly, and ends where the cost, which is rounded, does not fall any more: far above 1e-10.
constexpr double kNear = 1e-5;

/// Hyperbolic space (kTangent = 3) or the plane z = 0 in the given frame (2), as a set of points of
/// the hyperboloid. Moves are those of HarmonicEnergy's charts.
template <int kTangent>
class HyperbolicManifold final : public ceres::Manifold {
 public:
  explicit HyperbolicManifold(const Matrix4& frame) : frame_(frame) {}
  int AmbientSize() const override { return 4; }
  int TangentSize() const override { return kTangent; }

  bool Plus(const double* x, const double* delta, double* moved) const override {
    Vector4 u = Vector4::Zero();
    for (int k = 0; k < kTangent; ++k) u[k] = delta[k];
    u[3] = std::sqrt(1 + u.squaredNorm());
    Eigen::Map<Vector4> out(moved);
    out = basis(x) * u;
    return out.allFinite();
  }
  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 4, kTangent, Eigen::RowMajor>> out(jacobian);
    out = basis(x).template leftCols<kTangent>();
    return true;
  }
  bool Minus(const double* y, const double* x, double* difference) const override {
    const Vector4 u = geometry::lorentz_inverse(basis(x)) * Eigen::Map<const Vector4>(y);
    for (int k = 0; k < kTangent; ++k) difference[k] = u[k];
    return true;
  }
  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, kTangent, 4, Eigen::RowMajor>> out(jacobian);
    out = geometry::lorentz_inverse(basis(x)).template topRows<kTangent>();
    return true;
  }

 private:
  Matrix4 basis(const double* x) const {
    Vector3 place =
        (geometry::lorentz_inverse(frame_) * Eigen::Map<const Vector4>(x)).template head<3>();
    if (kTangent == 2) place[2] = 0;
    return frame_ * geometry::boost(place);
  }
  Matrix4 frame_;
};

/// log(from, to), as seen from `from` at the origin.
template <class T>
void logarithm(const T* from, const T* to, T* result) {
  // Differences first: they keep the digits of near points.
  T step[4];
  for (int i = 0; i < 4; ++i) step[i] = to[i] - from[i];
  const T along =
      (from[0] * step[0] + from[1] * step[1] + from[2] * step[2]) / (T(1) + from[3]) - step[3];
  T square(0);
  for (int i = 0; i < 3; ++i) {
    result[i] = step[i] + from[i] * along;
    square += result[i] * result[i];
  }
  T scale;
  if (square < T(1e-3)) {
    scale = T(1) +
            square * (T(-1.0 / 6) +
                      square * (T(3.0 / 40) +
                                square * (T(-15.0 / 336) + square * (T(105.0 / 3456) +
                                                                     square * T(-945.0 / 42240)))));
  } else {
    using std::log;
    using std::sqrt;
    const T sine = sqrt(square);
    scale = log(sine + sqrt(T(1) + square)) / sine;
  }
  for (int i = 0; i < 3; ++i) result[i] *= scale;
}

template <class T>
void carry(const Matrix4& isometry, const T* point, T* result) {
  for (int i = 0; i < 4; ++i) {
    result[i] = T(0);
    for (int j = 0; j < 4; ++j) result[i] += isometry(i, j) * point[j];
  }
}

/// sqrt(w / 2) log(f_a, g f_b), and the same from the other end. Gauss-Newton's matrix of the one
/// alone has, across a long edge, d^2 / sinh^2 d for the far end, next to nothing; of both it has
/// (d tanh(d / 2))^2 / 2 and (d coth(d / 2))^2 / 2 where the Hessian has d tanh(d / 2) and
/// d coth(d / 2).
struct Distance {
  Matrix4 isometry;
  double root;

  template <class T>
  bool operator()(const T* a, const T* b, T* residual) const {
    T y[4];
    carry(isometry, b, y);
    logarithm(a, static_cast<const T*>(y), residual);
    logarithm(static_cast<const T*>(y), a, residual + 3);
    for (int i = 0; i < 6; ++i) residual[i] *= root;
    return true;
  }
};

/// The gradient at one point: -sum of w log(f_v, g f_b) over its neighbours b, in the frame of its
/// plane, of which the first two entries count there. Parameters: the point, then its neighbours.
struct Balance {
  struct Arm {
    Matrix4 isometry;
    double weight;
  };
  Matrix4 frame;  // the inverse of the plane's
  int width;
  std::vector<Arm> arms;

  template <class T>
  bool operator()(T const* const* points, T* residual) const {
    T here[4], there[4], along[3];
    carry(frame, points[0], here);
    for (int k = 0; k < width; ++k) residual[k] = T(0);
    for (std::size_t n = 0; n < arms.size(); ++n) {
      carry(arms[n].isometry, points[n + 1], there);
      logarithm(static_cast<const T*>(here), static_cast<const T*>(there), along);
      for (int k = 0; k < width; ++k) residual[k] -= arms[n].weight * along[k];
    }
    return true;
  }
};

class Watch final : public ceres::IterationCallback {
 public:
  Watch(HarmonicMap& map, const Context& context) : map_(map), context_(context) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    map_.iterations = before + step.iteration;
    map_.linear_iterations += step.linear_solver_iterations;
    if (enough == 0)
      map_.history.push_back(
          {map_.iterations, step.cumulative_time_in_seconds, step.cost, step.gradient_max_norm});
    stopped = context_.stop_requested() || context_.expired();
    if (stopped) return ceres::SOLVER_ABORT;
    return step.cost < enough ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  int before = 0;     ///< steps of the problem before this one
  double enough = 0;  ///< ends at a lower cost than this
  bool stopped = false;

 private:
  HarmonicMap& map_;
  const Context& context_;
};

void add_points(ceres::Problem& problem, const energies::HarmonicEnergy& energy,
                std::vector<Vector4>& points) {
  for (std::size_t v = 0; v < points.size(); ++v) {
    ceres::Manifold* manifold = nullptr;
    if (energy.is_free(v))
      manifold = new HyperbolicManifold<3>(Matrix4::Identity());
    else
      manifold = new HyperbolicManifold<2>(energy.plane(v));
    problem.AddParameterBlock(points[v].data(), 4, manifold);
  }
}

void add_distances(ceres::Problem& problem, const energies::HarmonicEnergy& energy,
                   std::vector<Vector4>& points) {
  for (const energies::HarmonicEdge& edge : energy.edges())
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Distance, 6, 4, 4>(new Distance{
                                 energy.isometries()[edge.isometry], std::sqrt(edge.weight / 2)}),
                             nullptr, points[edge.a].data(), points[edge.b].data());
}

void add_balances(ceres::Problem& problem, const energies::HarmonicEnergy& energy,
                  std::vector<Vector4>& points) {
  std::vector<Balance> balances(points.size());
  std::vector<std::vector<double*>> blocks(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    balances[v].frame = geometry::lorentz_inverse(energy.plane(v));
    balances[v].width = energy.is_free(v) ? 3 : 2;
    blocks[v].push_back(points[v].data());
  }
  const auto pull = [&](std::size_t v, std::size_t to, const Matrix4& isometry, double weight) {
    balances[v].arms.push_back({balances[v].frame * isometry, weight});
    blocks[v].push_back(points[to].data());
  };
  for (const energies::HarmonicEdge& edge : energy.edges()) {
    const Matrix4& g = energy.isometries()[edge.isometry];
    pull(edge.a, edge.b, g, edge.weight);
    pull(edge.b, edge.a, geometry::lorentz_inverse(g), edge.weight);
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    const int width = balances[v].width;
    auto* cost =
        new ceres::DynamicAutoDiffCostFunction<Balance>(new Balance(std::move(balances[v])));
    for (std::size_t n = 0; n < blocks[v].size(); ++n) cost->AddParameterBlock(4);
    cost->SetNumResiduals(width);
    problem.AddResidualBlock(cost, nullptr, blocks[v]);
  }
}

}  // namespace

HarmonicMap minimised_by_ceres(energies::HarmonicEnergy& energy, const MapOptions& options,
                               const Context& context) {
  HarmonicMap map;
  const std::vector<double> x(energy.dimension(), 0.0);
  std::unique_ptr<solver::Evaluation> at;
  const auto measure = [&] {
    energy.evaluate(x, solver::Order::kFirst, at);
    map.energy = at->value();
    map.max_gradient = solver::max_abs(at->gradient());
  };
  std::vector<Vector4> points = energy.points(x);
  Watch watch(map, context);
  const auto start = std::chrono::steady_clock::now();
  const auto solve = [&](auto add_residuals, double gradient_tolerance) {
    ceres::Problem problem;
    add_points(problem, energy, points);
    add_residuals(problem, energy, points);
    ceres::Solver::Options solving;
    solving.max_num_iterations = options.max_iterations - map.iterations;
    if (options.time_limit < 1e9)
      solving.max_solver_time_in_seconds = std::max(options.time_limit - map.seconds, 0.0);
    solving.gradient_tolerance = gradient_tolerance;
    solving.function_tolerance = 0;
    solving.parameter_tolerance = 1e-16;
    solving.logging_type = ceres::SILENT;
    solving.linear_solver_type =
        points.size() <= kDirect ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::CGNR;
    solving.callbacks.push_back(&watch);
    ceres::Solver::Summary summary;
    ceres::Solve(solving, &problem, &summary);
    map.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    map.evaluations += summary.num_residual_evaluations;
    // Judged by the energy itself, not by what Ceres says.
    energy.rebase(points);
    measure();
  };
  measure();
  // With negative weights the energy is no sum of squares.
  if (std::ranges::all_of(energy.edges(), [](const auto& edge) { return edge.weight > 0; }))
    solve(add_distances, std::max(options.tolerance, kNear * map.max_gradient));
  else
    map.history.push_back({0, 0, map.energy, map.max_gradient});
  if (map.max_gradient > options.tolerance && !watch.stopped) {
    watch.before = map.iterations;
    watch.enough = options.tolerance * options.tolerance / 2;
    solve(add_balances, 0);
    map.history.push_back({map.iterations, map.seconds, map.energy, map.max_gradient});
  }
  map.points = energy.points(x);
  map.termination = map.max_gradient <= options.tolerance ? solver::Termination::kConverged
                    : watch.stopped                       ? solver::Termination::kInterrupted
                    : map.iterations >= options.max_iterations
                        ? solver::Termination::kIterationLimit
                    : map.seconds >= options.time_limit ? solver::Termination::kTimeLimit
                                                        : solver::Termination::kStalled;
  return map;
}

}  // namespace tripus::parameterise
