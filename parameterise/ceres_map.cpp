// The harmonic map by Ceres: nonlinear least squares on a product of hyperboloids and planes.
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include "parameterise/harmonic_map.hpp"
#include "solver/run.hpp"

namespace tripus::parameterise {
namespace {

using geometry::Vector3;

/// Beyond so many points a factorisation fills in too much; conjugate gradients on the normal
/// equations then.
constexpr std::size_t kDirect = 60'000;

Matrix4 boost(const Vector3& x) {
  const double time = std::sqrt(1 + x.squaredNorm());
  Matrix4 result = Matrix4::Identity();
  result.topLeftCorner<3, 3>() += x * x.transpose() / (1 + time);
  result.topRightCorner<3, 1>() = x;
  result.bottomLeftCorner<1, 3>() = x.transpose();
  result(3, 3) = time;
  return result;
}

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
    return frame_ * boost(place);
  }
  Matrix4 frame_;
};

/// sqrt(w) log(f_a, g f_b), as seen from f_a at the origin.
struct Residual {
  Matrix4 isometry;
  double root;

  template <class T>
  bool operator()(const T* a, const T* b, T* residual) const {
    T y[4];
    for (int i = 0; i < 4; ++i) {
      y[i] = T(0);
      for (int j = 0; j < 4; ++j) y[i] += isometry(i, j) * b[j];
    }
    // Differences first: they keep the digits of near points.
    T step[4];
    for (int i = 0; i < 4; ++i) step[i] = y[i] - a[i];
    const T along = (a[0] * step[0] + a[1] * step[1] + a[2] * step[2]) / (T(1) + a[3]) - step[3];
    T square(0);
    for (int i = 0; i < 3; ++i) {
      residual[i] = step[i] + a[i] * along;
      square += residual[i] * residual[i];
    }
    T scale;
    if (square < T(1e-3)) {
      scale =
          T(1) +
          square * (T(-1.0 / 6) +
                    square * (T(3.0 / 40) +
                              square * (T(-15.0 / 336) +
                                        square * (T(105.0 / 3456) + square * T(-945.0 / 42240)))));
    } else {
      using std::log;
      using std::sqrt;
      const T sine = sqrt(square);
      scale = log(sine + sqrt(T(1) + square)) / sine;
    }
    for (int i = 0; i < 3; ++i) residual[i] *= root * scale;
    return true;
  }
};

class Watch final : public ceres::IterationCallback {
 public:
  Watch(HarmonicMap& map, const Context& context) : map_(map), context_(context) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    map_.history.push_back(
        {step.iteration, step.cumulative_time_in_seconds, step.cost, step.gradient_max_norm});
    map_.iterations = step.iteration;
    map_.linear_iterations += step.linear_solver_iterations;
    stopped = context_.stop_requested() || context_.expired();
    return stopped ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }
  bool stopped = false;

 private:
  HarmonicMap& map_;
  const Context& context_;
};

}  // namespace

HarmonicMap minimised_by_ceres(energies::HarmonicEnergy& energy, std::span<const Vector4> poles,
                               const MapOptions& options, const Context& context) {
  std::vector<double> x(energy.dimension(), 0.0);
  std::vector<Vector4> points = energy.points(x);
  ceres::Problem problem;
  for (std::size_t v = 0; v < points.size(); ++v) {
    ceres::Manifold* manifold = nullptr;
    if (energy.is_free(v))
      manifold = new HyperbolicManifold<3>(Matrix4::Identity());
    else
      manifold = new HyperbolicManifold<2>(energy.plane(v));
    problem.AddParameterBlock(points[v].data(), 4, manifold);
  }
  for (const energies::HarmonicEdge& edge : energy.edges())
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 3, 4, 4>(new Residual{
                                 energy.isometries()[edge.isometry], std::sqrt(edge.weight)}),
                             nullptr, points[edge.a].data(), points[edge.b].data());
  ceres::Solver::Options solving;
  solving.max_num_iterations = options.max_iterations;
  if (options.time_limit < 1e9) solving.max_solver_time_in_seconds = options.time_limit;
  solving.gradient_tolerance = options.tolerance;
  solving.function_tolerance = 0;
  solving.parameter_tolerance = 1e-16;
  solving.logging_type = ceres::SILENT;
  solving.linear_solver_type =
      points.size() <= kDirect ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::CGNR;
  HarmonicMap map;
  Watch watch(map, context);
  solving.callbacks.push_back(&watch);
  ceres::Solver::Summary summary;
  const auto start = std::chrono::steady_clock::now();
  ceres::Solve(solving, &problem, &summary);
  map.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  map.evaluations = summary.num_residual_evaluations;
  // Judged by the energy itself, not by what Ceres says.
  energies::HarmonicEnergy judge({energy.edges().begin(), energy.edges().end()},
                                 {energy.isometries().begin(), energy.isometries().end()}, points,
                                 poles);
  std::vector<double> gradient(judge.dimension());
  judge.evaluate(x, gradient, {.value = &map.energy});
  map.max_gradient = solver::max_abs(gradient);
  map.points = judge.points(x);
  // Its own gradient, in other charts and other roundings, may have met the tolerance before.
  constexpr double kSlack = 10;
  map.termination = map.max_gradient <= kSlack * options.tolerance ? solver::Termination::kConverged
                    : watch.stopped ? solver::Termination::kInterrupted
                    : map.iterations >= options.max_iterations
                        ? solver::Termination::kIterationLimit
                    : map.seconds >= options.time_limit ? solver::Termination::kTimeLimit
                                                        : solver::Termination::kStalled;
  return map;
}

}  // namespace tripus::parameterise
