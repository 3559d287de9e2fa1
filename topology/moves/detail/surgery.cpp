#include "topology/moves/detail/surgery.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tripus::topology::detail {

std::size_t valence(const Gluings& gluings, const EdgeWalk& start) {
  std::size_t count = 0;
  EdgeWalk walk = start;
  do {
    if (gluings.is_open(walk.t, walk.c)) return 0;
    walk.step(gluings);
    ++count;
  } while (!is_same_corner(walk, start));
  return count;
}

bool is_same_edge(const Gluings& gluings, std::size_t t, int edge, std::size_t other,
                  int other_edge) {
  const auto start = EdgeWalk::start(t, edge);
  EdgeWalk walk = start;
  do {
    if (walk.t == other && walk.edge() == other_edge) return true;
    if (gluings.is_open(walk.t, walk.c)) return false;
    walk.step(gluings);
  } while (!is_same_corner(walk, start));
  return false;
}

void face_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves) {
  const Gluings& gluings = triangulation.gluings();
  for (TetrahedronIndex t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) {
      const TetrahedronIndex other = gluings.neighbour(t, f);
      if (other > t || (other == t && gluings.gluing(t, f)(f) > f))
        moves.push_back({.kind = kind, .tetrahedron = t, .place = static_cast<std::uint8_t>(f)});
    }
}

void edge_candidates(const Triangulation& triangulation, MoveKind kind, int choices,
                     std::vector<Move>& moves) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const EdgeCorner first = triangulation.corners(e)[0];
    for (int choice = 0; choice < choices; ++choice)
      moves.push_back({.kind = kind,
                       .tetrahedron = static_cast<TetrahedronIndex>(first.tetrahedron()),
                       .place = static_cast<std::uint8_t>(first.edge()),
                       .choice = static_cast<std::uint8_t>(choice)});
  }
}

void vertex_candidates(const Triangulation& triangulation, MoveKind kind,
                       std::vector<Move>& moves) {
  std::vector<bool> seen(triangulation.vertex_count(), false);
  for (TetrahedronIndex t = 0; t < triangulation.tetrahedron_count(); ++t)
    for (int v = 0; v < 4; ++v) {
      const auto vertex = triangulation.vertex_class(t, v);
      if (seen[vertex]) continue;
      seen[vertex] = true;
      moves.push_back({.kind = kind, .tetrahedron = t, .place = static_cast<std::uint8_t>(v)});
    }
}

void Surgery::flatten(TetrahedronIndex t, int f, TetrahedronIndex other, Perm4 q) {
  ports_.push_back({t, f, true, other, q});
  ports_.push_back({other, q(f), true, t, q.inverse()});
}

const Surgery::Port* Surgery::port(TetrahedronIndex t, int f) const {
  for (const Port& candidate : ports_)
    if (candidate.t == t && candidate.f == f) return &candidate;
  return nullptr;
}

bool Surgery::is_sealed() const {
  for (const Port& start : ports_) {
    if (!start.flat) continue;
    // Every step can be undone, so a way that does not get out comes back to its start.
    const Port* here = &start;
    do {
      const Perm4 p = gluings_->gluing(here->t, here->f);
      here = port(gluings_->neighbour(here->t, here->f), p(here->f));
      if (here != nullptr) here = here->flat ? port(here->to, here->map(here->f)) : nullptr;
    } while (here != nullptr && here != &start);
    if (here == &start) return true;
  }
  return false;
}

Surgery::End Surgery::follow(TetrahedronIndex t, int f) const {
  Perm4 map;
  while (true) {
    const Perm4 p = gluings_->gluing(t, f);
    t = gluings_->neighbour(t, f);
    f = p(f);
    map = p * map;
    const Port* behind = port(t, f);
    if (behind == nullptr) return {false, t, map};
    map = behind->map * map;
    f = behind->map(f);
    t = behind->to;
    if (!behind->flat) return {true, t, map};
  }
}

// Everything is read here, before anything is written.
Surgery::Glues Surgery::glues(std::span<const TetrahedronIndex> numbers) const {
  const auto number = [&](bool fresh, TetrahedronIndex t) { return fresh ? numbers[t] : t; };
  Glues glues;
  for (const Join& join : joins_)
    glues.push_back({numbers[static_cast<std::size_t>(join.fresh)], join.f,
                     numbers[static_cast<std::size_t>(join.other)], join.map});
  for (const Port& start : ports_) {
    const End far = follow(start.t, start.f);
    if (!start.flat) {
      glues.push_back({numbers[start.to], start.map(start.f), number(far.fresh, far.t),
                       far.map * start.map.inverse()});
      continue;
    }
    // The other end of the chain, from the face upon which this one is laid.
    const int f = start.map(start.f);
    const End near = follow(start.to, f);
    if (near.fresh) continue;  // glued from there
    glues.push_back({near.t, near.map(f), number(far.fresh, far.t),
                     far.map * start.map.inverse() * near.map.inverse()});
  }
  return glues;
}

MoveChange Surgery::apply(Gluings& gluings) const {
  MoveChange change;
  change.removed = removed_;
  std::ranges::sort(change.removed);
  const std::size_t before = gluings.tetrahedron_count();
  const std::size_t reused =
      std::min<std::size_t>(removed_.size(), static_cast<std::size_t>(added_));
  for (std::size_t k = 0; k < static_cast<std::size_t>(added_); ++k)
    change.added.push_back(k < reused ? change.removed[k]
                                      : static_cast<TetrahedronIndex>(before + k - reused));
  const Glues all = glues({change.added.begin(), change.added.size()});
  gluings.resize(before + static_cast<std::size_t>(added_) - reused);
  for (const Glue& glue : all) gluings.glue(glue.t, glue.f, glue.other, glue.map);

  for (std::size_t k = change.removed.size(); k-- > reused;) {
    const TetrahedronIndex hole = change.removed[k];
    const auto last = static_cast<TetrahedronIndex>(gluings.tetrahedron_count() - 1);
    gluings.remove_tetrahedron(hole);
    if (hole == last) continue;
    auto* known = std::ranges::find(change.renumbered, last, &MoveChange::Renumbered::to);
    if (known != change.renumbered.end())
      known->to = hole;
    else
      change.renumbered.push_back({last, hole});
  }
  return change;
}

int vertex_at(const Points& points, int point) {
  return static_cast<int>(std::ranges::find(points, point) - points.begin());
}

int edge_at(const Points& points, int first, int second) {
  return kEdgeNumber[static_cast<std::size_t>(vertex_at(points, first))]
                    [static_cast<std::size_t>(vertex_at(points, second))];
}

namespace {

unsigned face_mask(const Points& points, int f) {
  return point_mask(points) & ~(1u << points[static_cast<std::size_t>(f)]);
}

/// From face f of one tetrahedron to the face with the same points of another, if it has one.
std::optional<Perm4> matching(const Points& from, int f, const Points& to) {
  if ((face_mask(from, f) & ~point_mask(to)) != 0) return std::nullopt;
  std::array<int, 4> images{};
  int left = 6;
  for (int v = 0; v < 4; ++v)
    if (v != f)
      left -= images[static_cast<std::size_t>(v)] =
          vertex_at(to, from[static_cast<std::size_t>(v)]);
  images[static_cast<std::size_t>(f)] = left;
  return Perm4::from_images(images[0], images[1], images[2], images[3]);
}

/// Swaps two vertices of new tetrahedra that lie the other way round than the old ones.
void orient(MoveBall& ball) {
  for (Points& points : ball.fresh)
    for (const Piece& piece : ball.old)
      for (int f = 0; f < 4; ++f) {
        if ((face_mask(piece.points, f) & ball.core) == ball.core) continue;
        const auto q = matching(piece.points, f, points);
        if (q && q->is_odd()) std::swap(points[2], points[3]);
      }
}

}  // namespace

Surgery plan_ball(const Gluings& gluings, MoveBall& ball) {
  orient(ball);
  const auto& [old, core, fresh] = ball;
  Surgery surgery(gluings);
  unsigned taken[4] = {0, 0, 0, 0};  // faces of the new tetrahedra
  for (const Piece& piece : old) surgery.remove(piece.t);
  for (std::size_t k = 0; k < fresh.size(); ++k) surgery.add();
  for (std::size_t i = 0; i < old.size(); ++i)
    for (int f = 0; f < 4; ++f) {
      if ((face_mask(old[i].points, f) & core) == core) continue;
      for (std::size_t k = 0; k < fresh.size(); ++k)
        if (const auto q = matching(old[i].points, f, fresh[k])) {
          surgery.carry(old[i].t, f, static_cast<int>(k), *q);
          taken[k] |= 1u << (*q)(f);
        }
      for (std::size_t j = i + 1; j < old.size(); ++j)
        if (const auto q = matching(old[i].points, f, old[j].points))
          surgery.flatten(old[i].t, f, old[j].t, *q);
    }
  for (std::size_t k = 0; k < fresh.size(); ++k)
    for (int f = 0; f < 4; ++f)
      for (std::size_t j = k + 1; j < fresh.size() && (taken[k] >> f & 1) == 0; ++j)
        if (const auto q = matching(fresh[k], f, fresh[j]))
          surgery.join(static_cast<int>(k), f, static_cast<int>(j), *q);
  return surgery;
}

}  // namespace tripus::topology::detail
