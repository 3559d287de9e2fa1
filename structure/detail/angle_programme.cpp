#include "structure/detail/angle_programme.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <glpk.h>

// Columns of GLPK's matrix, from 1: angle - m >= 0 of each corner, then m. With the angles measured
// from m upwards the only bounds left are signs. All coefficients are small integers, so there is
// nothing to scale.

namespace tripus::structure::detail {
namespace {

/// Whether each thread has an environment of its own; then GLPK forgets to free those of threads
/// that end.
bool has_environment_per_thread() { return glp_config("TLS") != nullptr; }

std::unique_lock<std::mutex> lock_if_needed() {
  static std::mutex mutex;
  return has_environment_per_thread() ? std::unique_lock<std::mutex>() : std::unique_lock(mutex);
}

/// True if it is ours to free.
bool make_environment() { return glp_init_env() == 0 && has_environment_per_thread(); }

/// The sparse matrix of the programme as GLPK takes it: 1-based triplets behind a dummy.
struct Triplets {
  std::vector<int> row{0}, column{0};
  std::vector<double> value{0};
  void add(int r, int c, double v) {
    row.push_back(r);
    column.push_back(c);
    value.push_back(v);
  }
};

glp_smcp simplex_options(int milliseconds) {
  glp_smcp options;
  glp_init_smcp(&options);
  options.tm_lim = milliseconds;
  options.msg_lev = GLP_MSG_OFF;
  return options;
}

}  // namespace

std::size_t most_tetrahedra_decided() { return 10000; }

AngleProgramme::AngleProgramme(const topology::Triangulation& triangulation,
                               std::span<const topology::ConeAngle> cone_angles)
    : lock_(lock_if_needed()),
      owns_environment_(make_environment()),
      old_term_out_(glp_term_out(GLP_OFF)),
      constraints_(triangulation, cone_angles),
      corner_count_(6 * triangulation.tetrahedron_count()),
      edge_count_(triangulation.edge_count()),
      programme_(glp_create_prob()) {
  glp_set_obj_dir(programme_, GLP_MAX);
  add_columns();
  add_rows(triangulation);
}

AngleProgramme::~AngleProgramme() {
  glp_delete_prob(programme_);
  glp_term_out(old_term_out_);
  if (owns_environment_) glp_free_env();
}

void AngleProgramme::add_columns() {
  const int margin = static_cast<int>(corner_count_) + 1;
  glp_add_cols(programme_, margin);
  for (int c = 1; c < margin; ++c) glp_set_col_bnds(programme_, c, GLP_LO, 0, 0);
  glp_set_col_bnds(programme_, margin, GLP_FR, 0, 0);
  glp_set_obj_coef(programme_, margin, 1);
}

void AngleProgramme::add_rows(const topology::Triangulation& triangulation) {
  const int edges = static_cast<int>(edge_count_);
  const int vertices = static_cast<int>(4 * triangulation.tetrahedron_count());
  const int margin = static_cast<int>(corner_count_) + 1;
  glp_add_rows(programme_, edges + vertices);
  Triplets a;
  for (int e = 0; e < edges; ++e) {
    const auto around = triangulation.corners(static_cast<std::size_t>(e));
    const double sum = constraints_.edge_sum[static_cast<std::size_t>(e)];
    const bool parabolic = constraints_.parabolic[static_cast<std::size_t>(e)];
    glp_set_row_bnds(programme_, e + 1, parabolic ? GLP_FR : GLP_FX, sum, sum);
    for (const auto corner : around) {
      const int column = static_cast<int>(6 * corner.tetrahedron()) + corner.edge() + 1;
      if (parabolic) {
        glp_set_col_bnds(programme_, column, GLP_FX, 0, 0);
      } else {
        a.add(e + 1, column, 1);
      }
    }
    if (parabolic) continue;
    a.add(e + 1, margin, static_cast<double>(around.size()));
  }
  for (int v = 0; v < vertices; ++v) {
    const int row = edges + v + 1;
    const auto vertex = static_cast<std::size_t>(v);
    glp_set_row_bnds(programme_, row, constraints_.ideal[vertex] ? GLP_FX : GLP_UP, 1, 1);
    for (int other = 0; other < 4; ++other) {
      const int edge =
          topology::kEdgeNumber[static_cast<std::size_t>(v % 4)][static_cast<std::size_t>(other)];
      if (edge < 0) continue;
      const std::size_t t = static_cast<std::size_t>(v / 4);
      if (!constraints_.parabolic[triangulation.edge_class(t, edge)])
        a.add(row, 6 * (v / 4) + edge + 1, 1);
    }
    // Three angles and, where the sum may be less than pi, the gap itself.
    a.add(row, margin, constraints_.corners[vertex] + (constraints_.ideal[vertex] ? 0 : 1));
  }
  glp_load_matrix(programme_, static_cast<int>(a.row.size()) - 1, a.row.data(), a.column.data(),
                  a.value.data());
}

void AngleProgramme::limit_time(double seconds) {
  constexpr double kLongest = 1e8;  // three years
  if (!(seconds < kLongest)) return;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(std::max(seconds, 0.0)));
}

int AngleProgramme::milliseconds_left() const {
  if (deadline_ == Clock::time_point::max()) return std::numeric_limits<int>::max();
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 1, std::numeric_limits<int>::max()));
}

bool AngleProgramme::solve() {
  // A triangular basis to begin with and the dual method: 6 to 10 times as fast as GLPK's defaults
  // on covers of 2,000 tetrahedra in random order. It goes on to the primal method if this fails.
  glp_smcp options = simplex_options(milliseconds_left());
  options.meth = GLP_DUALP;
  glp_adv_basis(programme_, 0);
  return glp_simplex(programme_, &options) == 0 && glp_get_status(programme_) == GLP_OPT;
}

bool AngleProgramme::solve_exactly() {
  // A failed floating-point run may leave a basis that is singular in rational arithmetic.
  const glp_smcp options = simplex_options(milliseconds_left());
  if (glp_exact(programme_, &options) == 0 && glp_get_status(programme_) == GLP_OPT) return true;
  if (is_out_of_time()) return false;
  glp_std_basis(programme_);
  return glp_exact(programme_, &options) == 0 && glp_get_status(programme_) == GLP_OPT;
}

double AngleProgramme::margin() const {
  return glp_get_col_prim(programme_, static_cast<int>(corner_count_) + 1);
}

std::vector<double> AngleProgramme::angles() const {
  std::vector<double> found(corner_count_);
  for (std::size_t c = 0; c < corner_count_; ++c)
    found[c] = glp_get_col_type(programme_, static_cast<int>(c) + 1) == GLP_FX
                   ? 0
                   : glp_get_col_prim(programme_, static_cast<int>(c) + 1) + margin();
  return found;
}

std::vector<double> AngleProgramme::vertex_multipliers() const {
  const std::size_t rows = static_cast<std::size_t>(glp_get_num_rows(programme_));
  std::vector<double> found;
  found.reserve(rows - edge_count_);
  for (std::size_t r = edge_count_; r < rows; ++r)
    found.push_back(glp_get_row_dual(programme_, static_cast<int>(r) + 1));
  return found;
}

AngleProgramme::Basis AngleProgramme::basis() const {
  Basis found;
  const int rows = glp_get_num_rows(programme_);
  for (int r = 1; r <= rows; ++r)
    if (glp_get_row_stat(programme_, r) != GLP_BS)
      found.rows.push_back(static_cast<std::size_t>(r - 1));
  const int columns = glp_get_num_cols(programme_);
  for (int c = 1; c <= columns; ++c)
    if (glp_get_col_stat(programme_, c) == GLP_BS)
      found.columns.push_back(static_cast<std::size_t>(c - 1));
  return found;
}

}  // namespace tripus::structure::detail
