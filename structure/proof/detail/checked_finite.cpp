#include "structure/proof/detail/checked_finite.hpp"

#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "structure/proof/detail/arb_number.hpp"

namespace tripus::structure::detail {
namespace {

using Vector = std::array<Arb, 3>;

constexpr int kEdge[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

std::size_t index(int v) { return static_cast<std::size_t>(v); }
std::size_t edge_at(int v, int w) { return static_cast<std::size_t>(kEdge[v][w]); }

Arb inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Arb absolute(const Arb& x) {
  Arb result;
  arb_abs(result.get(), x.get());
  return result.upper_end();
}

/// The directions of all edge ends at one finite vertex, each end once.
class Star {
 public:
  struct End {
    std::size_t edge;
    Vector direction;
  };

  Star(const FiniteClaim& claim, std::size_t vertex) : claim_(claim) {
    for (std::size_t t = 0; t < claim.triangulation.tetrahedron_count(); ++t)
      for (int v = 0; v < 4; ++v)
        if (claim.triangulation.vertex_class(t, v) == vertex) {
          begin(t, v);
          grow();
          return;
        }
  }

  bool known() const { return known_; }

  /// The places of one end are those that walking around its edge reaches.
  std::vector<End> ends() const {
    std::map<Place, std::size_t> end_of;
    std::vector<End> result;
    for (const auto& [corner, directions] : placed_)
      for (int w = 0; w < 4; ++w) {
        if (w == corner.second || end_of.contains({corner.first, corner.second, w})) continue;
        End end{claim_.triangulation.edge_class(corner.first, kEdge[corner.second][w]),
                directions[index(w)]};
        std::vector<Place> todo{{corner.first, corner.second, w}};
        end_of[todo[0]] = result.size();
        while (!todo.empty()) {
          const auto [t, v, u] = todo.back();
          todo.pop_back();
          for (std::size_t i = 0; i < 3; ++i)
            arb_union(end.direction[i].get(), end.direction[i].get(),
                      placed_.at({t, v})[index(u)][i].get(), Precision::bits());
          for (int f = 0; f < 4; ++f) {
            if (f == v || f == u) continue;
            const topology::Perm4 p = gluings().gluing(t, f);
            const Place next{gluings().neighbour(t, f), p(v), p(u)};
            if (end_of.emplace(next, result.size()).second) todo.push_back(next);
          }
        }
        result.push_back(std::move(end));
      }
    return result;
  }

 private:
  using Place = std::tuple<std::size_t, int, int>;
  using Corner = std::pair<std::size_t, int>;  // tetrahedron, vertex

  const topology::Gluings& gluings() const { return claim_.triangulation.gluings(); }

  /// <a, b> of the unit vectors from v towards a and b: (G_ab + G_va G_vb) / (s_va s_vb).
  Arb cosine(std::size_t t, int v, int a, int b) const {
    const CheckedGram& m = claim_.within[t];
    return (m.g[index(a)][index(b)] + m.g[index(v)][index(a)] * m.g[index(v)][index(b)]) /
           (m.slope[edge_at(v, a)] * m.slope[edge_at(v, b)]);
  }

  /// The unit vector with these products with a and b, on one side of them.
  Vector third(const Vector& a, const Vector& b, const Arb& ab, const Arb& with_a,
               const Arb& with_b, const Vector& normal) const {
    const Arb rest = Arb(1.0) - ab * ab;
    const Arb alpha = (with_a - ab * with_b) / rest, beta = (with_b - ab * with_a) / rest;
    const Arb height = square_root(Arb(1.0) - alpha * with_a - beta * with_b);
    Vector result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = alpha * a[i] + beta * b[i] + height * normal[i];
    return result;
  }

  void begin(std::size_t t, int v) {
    const int a = v == 0 ? 1 : 0, b = v <= 1 ? 2 : 1, c = 6 - v - a - b;
    const Arb ab = cosine(t, v, a, b);
    auto& directions = placed_[{t, v}];
    directions[index(a)] = {Arb(1.0), Arb(), Arb()};
    directions[index(b)] = {ab, square_root(Arb(1.0) - ab * ab), Arb()};
    directions[index(c)] = third(directions[index(a)], directions[index(b)], ab, cosine(t, v, a, c),
                                 cosine(t, v, b, c), {Arb(), Arb(), Arb(1.0)});
    todo_.push_back({t, v});
  }

  void grow() {
    while (!todo_.empty() && known_) {
      const auto [t, v] = todo_.front();
      todo_.erase(todo_.begin());
      for (int f = 0; f < 4; ++f)
        if (f != v) across(t, v, f);
    }
  }

  void across(std::size_t t, int v, int f) {
    const topology::Perm4 p = gluings().gluing(t, f);
    const std::size_t other = gluings().neighbour(t, f);
    if (placed_.contains({other, p(v)})) return;
    int a = 0;
    while (a == v || a == f) ++a;
    const int b = 6 - v - f - a;
    const auto& here = placed_.at({t, v});
    const Vector u = here[index(a)], w = here[index(b)];
    Vector normal = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                     u[0] * w[1] - u[1] * w[0]};
    const Arb side = inner(normal, here[index(f)]);
    if (!side.positive() && !side.negative()) {
      known_ = false;
      return;
    }
    const Arb scale = Arb(side.positive() ? -1.0 : 1.0) / square_root(inner(normal, normal));
    for (Arb& x : normal) x = scale * x;
    auto& there = placed_[{other, p(v)}];
    there[index(p(a))] = u;
    there[index(p(b))] = w;
    there[index(p(f))] =
        third(u, w, cosine(other, p(v), p(a), p(b)), cosine(other, p(v), p(a), p(f)),
              cosine(other, p(v), p(b), p(f)), normal);
    todo_.push_back({other, p(v)});
  }

  const FiniteClaim& claim_;
  bool known_ = true;
  std::map<Corner, std::array<Vector, 4>> placed_;
  std::vector<Corner> todo_;
};

/// One row of theory (109).
struct Row {
  std::vector<Arb> entry;  // [E]
  Arb constant;            // C
};

struct FiniteChecker {
  const FiniteClaim& claim;
  std::vector<std::size_t> held{}, free{};

  bool is_held(std::size_t e) const {
    return arb_is_zero(claim.radius[e].get()) != 0 && !claim.cone_angles[e].is_parabolic();
  }
  bool is_full(std::size_t e) const { return claim.cone_angles[e].is_full(); }

  /// Interval Newton: J over the box, solved for K at the lengths.
  std::string newton() const {
    const std::size_t n = free.size();
    std::map<std::size_t, std::size_t> row;
    for (const std::size_t e : free) row.emplace(e, row.size());
    ArbMatrix J(n, n), K(n, 1), step(n, 1);
    for (std::size_t t = 0; t < claim.around.size(); ++t) {
      const auto own = checked_jacobian(claim.around[t]);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const auto a = row.find(claim.triangulation.edge_class(t, i));
          const auto b = row.find(claim.triangulation.edge_class(t, j));
          if (a == row.end() || b == row.end()) continue;
          arb_ptr at = J.at(a->second, b->second);
          arb_add(at, at, own[index(i)][index(j)].get(), Precision::bits());
        }
    }
    for (std::size_t k = 0; k < n; ++k) arb_set(K.at(k, 0), claim.K[free[k]].get());
    if (n > 0 && arb_mat_solve(step.get(), J.get(), K.get(), Precision::bits()) == 0)
      return "the Jacobian is not shown to be regular";
    for (std::size_t k = 0; k < n; ++k) {
      Arb reach;
      arb_set(reach.get(), step.at(k, 0));
      const Arb most = absolute(reach);
      const std::size_t e = free[k];
      if (!arb_le(most.get(), claim.radius[e].get()) || !(claim.box[e] - most).positive())
        return fmt::format(
            "edge class {}: its length is only shown to be within {:.6g}, not {:.6g}", e,
            most.upper(), claim.radius[e].mid());
    }
    return {};
  }

  /// Rows for vertex v; false if it cannot be shown how it moves.
  bool add_rows(std::size_t v, std::vector<Row>& rows) const {
    const std::size_t count = claim.radius.size();
    if (claim.links[v].kind == topology::VertexKind::kHyperideal) return true;
    if (claim.links[v].kind == topology::VertexKind::kIdeal) {
      Row row{std::vector<Arb>(count), Arb()};
      for (std::size_t e = 0; e < count; ++e) {
        const topology::EdgeCorner corner = claim.triangulation.corners(e)[0];
        for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
          if (claim.triangulation.vertex_class(corner.tetrahedron(), end) == v)
            row.entry[e] = row.entry[e] + Arb(1.0);
      }
      rows.push_back(std::move(row));
      return true;
    }
    const Star star(claim, v);
    if (!star.known()) return false;
    const std::vector<Star::End> ends = star.ends();
    std::vector<const Star::End*> singular;
    double held_ends = 0;
    for (const Star::End& end : ends) {
      if (!is_full(end.edge)) singular.push_back(&end);
      held_ends += is_held(end.edge);
    }
    if (singular.size() > 2) return true;
    if (singular.size() == 1) return false;
    Arb factor(1.0);
    if (!singular.empty()) {
      const auto spread = along_singular_edge(*singular[0], *singular[1], ends);
      if (!spread) return false;
      factor = *spread;
    }
    const Arb constant = 0.5 * (Arb(held_ends * held_ends) * factor);
    for (std::size_t i = 0; i < (singular.empty() ? 3u : 1u); ++i) {
      Row row{std::vector<Arb>(count), constant};
      for (const Star::End& end : ends)
        row.entry[end.edge] =
            row.entry[end.edge] +
            (singular.empty() ? end.direction[i] : inner(end.direction, singular[0]->direction));
      rows.push_back(std::move(row));
    }
    return true;
  }

  /// (1 + (1 + m) / (|sin(k/2)| - m))^2 of theory (108).
  std::optional<Arb> along_singular_edge(const Star::End& a, const Star::End& b,
                                         const std::vector<Star::End>& ends) const {
    if (is_held(a.edge) || is_held(b.edge)) return std::nullopt;
    Arb chord, turn;
    for (std::size_t i = 0; i < 3; ++i) chord = chord + square(a.direction[i] + b.direction[i]);
    for (const Star::End& end : ends)
      if (is_held(end.edge)) turn = turn + absolute(claim.K_within[end.edge]);
    const Arb pi = number_pi(Arb());
    const Arb m = 0.5 * turn + 0.5 * (pi * square_root(chord.upper_end()));
    Arb sine = Arb(0.5 * claim.cone_angles[a.edge].radians());
    const topology::ConeAngle& k = claim.cone_angles[a.edge];
    if (k.is_rational())
      sine = 0.5 * (Arb(static_cast<double>(k.numerator())) /
                    Arb(static_cast<double>(k.denominator())) * pi);
    arb_sin(sine.get(), sine.get(), Precision::bits());
    arb_abs(sine.get(), sine.get());
    const Arb left = sine - m;
    if (!left.positive()) return std::nullopt;
    return square(Arb(1.0) + (Arb(1.0) + m) / left);
  }

  /// Theory (109), with the solution of M y = (1, .., 1) in absolute values in place of |M^-1|.
  std::string held_curvatures() const {
    std::vector<Row> rows;
    for (std::size_t v = 0; v < claim.links.size(); ++v)
      if (!add_rows(v, rows))
        return fmt::format("vertex class {}: its edge ends are not enclosed well enough", v);
    const std::size_t n = held.size();
    if (rows.size() != n)
      return fmt::format("{} lengths have the radius 0; there are {} ways to move vertices", n,
                         rows.size());
    if (n == 0) return {};
    ArbMatrix M(n, n), one(n, n), inverse(n, n);
    Arb constant, largest, norm;
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t k = 0; k < n; ++k) arb_set(M.at(r, k), rows[r].entry[held[k]].get());
      arb_one(one.at(r, r));
      const Arb most = rows[r].constant.upper_end();
      if (larger(most, constant)) constant = most;
      const Arb size = absolute(claim.K_within[held[r]]);
      if (larger(size, largest)) largest = size;
    }
    if (arb_mat_solve(inverse.get(), M.get(), one.get(), Precision::bits()) == 0)
      return "the lengths with the radius 0 are not shown to hold the vertices in place";
    for (std::size_t r = 0; r < n; ++r) {
      Arb sum;
      for (std::size_t k = 0; k < n; ++k) {
        Arb entry;
        arb_set(entry.get(), inverse.at(r, k));
        sum = sum + absolute(entry);
      }
      sum = sum.upper_end();
      if (larger(sum, norm)) norm = sum;
    }
    const Arb product = constant * norm * largest;
    if (!(Arb(1.0) - product).positive())
      return fmt::format("the curvatures of held edges: {:.6g} < 1 fails", product.upper());
    return {};
  }
};

}  // namespace

std::string finite_refusal(const FiniteClaim& claim) {
  FiniteChecker checker{claim};
  for (std::size_t e = 0; e < claim.radius.size(); ++e) {
    if (claim.cone_angles[e].is_parabolic()) continue;
    (checker.is_held(e) ? checker.held : checker.free).push_back(e);
  }
  std::string refusal = checker.newton();
  return refusal.empty() ? checker.held_curvatures() : refusal;
}

}  // namespace tripus::structure::detail
