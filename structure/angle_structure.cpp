#include "structure/angle_structure.hpp"

#include <memory>
#include <mutex>
#include <numbers>
#include <string>

#include <glpk.h>

#include "base/error.hpp"
#include "geometry/truncated_tetrahedron.hpp"

namespace tripus::structure {
namespace {

constexpr double kPi = std::numbers::pi;

struct DeleteProblem {
  void operator()(glp_prob* p) const { glp_delete_prob(p); }
};

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

/// Columns: angle - m >= 0 of each corner (1-based: 6 t + e + 1), then m. With the angles measured
/// from m upwards the only bounds left are signs.
void fill_programme(glp_prob* programme, const topology::Triangulation& triangulation,
                    std::span<const double> cone_angles) {
  const int corners = static_cast<int>(6 * triangulation.tetrahedron_count());
  const int edges = static_cast<int>(triangulation.edge_count());
  const int margin = corners + 1;
  const int vertices = static_cast<int>(4 * triangulation.tetrahedron_count());
  glp_set_obj_dir(programme, GLP_MAX);
  glp_add_cols(programme, margin);
  for (int c = 1; c <= corners; ++c) glp_set_col_bnds(programme, c, GLP_LO, 0, 0);
  glp_set_col_bnds(programme, margin, GLP_FR, 0, 0);
  glp_set_obj_coef(programme, margin, 1);
  glp_add_rows(programme, edges + vertices);

  Triplets a;
  for (int e = 0; e < edges; ++e) {
    const auto around = triangulation.corners(static_cast<std::size_t>(e));
    const double sum = cone_angles.empty() ? 2 * kPi : cone_angles[static_cast<std::size_t>(e)];
    glp_set_row_bnds(programme, e + 1, GLP_FX, sum, sum);
    for (const auto corner : around)
      a.add(e + 1, static_cast<int>(6 * corner.tetrahedron()) + corner.edge() + 1, 1);
    a.add(e + 1, margin, static_cast<double>(around.size()));
  }
  for (int v = 0; v < vertices; ++v) {
    const int row = edges + v + 1;
    glp_set_row_bnds(programme, row, GLP_UP, 0, kPi);
    for (const int e : geometry::kEdgesAtVertex[static_cast<std::size_t>(v % 4)])
      a.add(row, 6 * (v / 4) + e + 1, 1);
    a.add(row, margin, 4);  // three angles and the gap itself
  }
  glp_load_matrix(programme, static_cast<int>(a.row.size()) - 1, a.row.data(), a.column.data(),
                  a.value.data());
}

}  // namespace

AngleStructure deepest_angle_structure(const topology::Triangulation& triangulation,
                                       std::span<const double> cone_angles) {
  // GLPK keeps an environment for each thread only if it was built so.
  static std::mutex mutex;
  const std::unique_lock lock =
      glp_config("TLS") == nullptr ? std::unique_lock(mutex) : std::unique_lock<std::mutex>();
  glp_term_out(GLP_OFF);
  const std::unique_ptr<glp_prob, DeleteProblem> programme(glp_create_prob());
  fill_programme(programme.get(), triangulation, cone_angles);
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  if (glp_simplex(programme.get(), &options) != 0 || glp_get_status(programme.get()) != GLP_OPT) {
    throw InternalError("the simplex method did not solve the angle-structure programme");
  }
  AngleStructure found;
  found.margin = glp_get_obj_val(programme.get());
  const std::size_t corners = 6 * triangulation.tetrahedron_count();
  found.angles.resize(corners);
  for (std::size_t c = 0; c < corners; ++c)
    found.angles[c] = glp_get_col_prim(programme.get(), static_cast<int>(c) + 1) + found.margin;
  return found;
}

}  // namespace tripus::structure
