#include "manifold/manifold.hpp"

#include <list>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "canonical/identify.hpp"
#include "manifold/labels.hpp"
#include "manifold/load.hpp"
#include "manifold/report_json.hpp"
#include "manifold/subject.hpp"
#include "topology/drill.hpp"
#include "topology/isosig.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/orientation.hpp"

namespace tripus {
namespace {

/// A value that is made when first asked for, by one thread while the others wait.
template <class T>
class Once {
 public:
  /// `make` returns the value and whether it is final; one that is not is made again when asked for
  /// again. Values stay where they are, so references to earlier ones remain good.
  template <class Make>
  const T& get(Make&& make) {
    const std::lock_guard lock(mutex_);
    if (!final_) {
      auto [value, is_final] = make();
      values_.push_back(std::move(value));
      final_ = is_final;
    }
    return values_.back();
  }

 private:
  std::mutex mutex_;
  std::list<T> values_;
  bool final_ = false;
};

/// Cone angles [E] as a cover has them, tetrahedron k T + t of which lies above t.
std::vector<topology::ConeAngle> lifted(std::span<const topology::ConeAngle> cone_angles,
                                        const topology::Triangulation& base,
                                        const topology::Triangulation& cover) {
  std::vector<topology::ConeAngle> result;
  for (std::size_t e = 0; e < cover.edge_count(); ++e) {
    const topology::EdgeCorner corner = cover.corners(e)[0];
    result.push_back(cone_angles[base.edge_class(
        topology::TetrahedronIndex(corner.tetrahedron() % base.tetrahedron_count()),
        corner.edge())]);
  }
  return result;
}

Manifold cover_of(const Manifold& base, topology::Gluings gluings) {
  Manifold cover(std::move(gluings));
  if (topology::all_full(base.cone_angles())) return cover;
  return cover.with_cone_angles(
      lifted(base.cone_angles(), base.triangulation(), cover.triangulation()));
}

/// Keeps every cover of a search as a manifold.
topology::VisitCover collect_in(std::vector<Manifold>& result, const Manifold& base) {
  return [&result, &base](const topology::Cover& cover) {
    result.push_back(cover_of(base, cover.gluings));
    return true;
  };
}

void require_plain(const Manifold& manifold, const char* what) {
  if (!topology::all_full(manifold.cone_angles()))
    throw Unsupported(std::string(what) +
                      " does not keep cone angles other than 2 pi so far; the manifold without "
                      "them is with_cone_angles({})");
}

bool was_cut_short(const structure::Report& report) {
  return report.termination == solver::Termination::kInterrupted ||
         report.termination == solver::Termination::kTimeLimit;
}

}  // namespace

/// What copies of a manifold share.
struct Manifold::State {
  State(topology::Triangulation given, std::string given_name, std::string given_input, bool known,
        std::vector<topology::ConeAngle> labels)
      : triangulation(std::move(given)),
        name(std::move(given_name)),
        input(std::move(given_input)),
        orientation_known(known),
        cone_angles(std::move(labels)) {}

  struct Solved {
    Solved(const State& state, structure::Report found)
        : report(std::move(found)), metric(state.triangulation, report, state.cone_angles) {}
    structure::Report report;
    Metric metric;
  };

  topology::Triangulation triangulation;
  std::string name;
  std::string input;
  bool orientation_known;                        ///< false for a signature without a sign
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty if nothing is labelled
  mutable Once<std::optional<std::string>> signature;
  mutable Once<topology::AbelianGroup> homology;
  mutable Once<std::unique_ptr<Solved>> solved;
  mutable Once<canonical::CanonizeAnswer> canonical;

  const Solved& solve(const Manifold& manifold, const Context& context) const {
    return *solved.get([&] {
      auto result = std::make_unique<Solved>(*this, manifold.solve({}, context));
      const bool is_final = !was_cut_short(result->report);
      return std::pair(std::move(result), is_final);
    });
  }

  /// As solving, the decompositions and what follows from them want it.
  canonical::CanonizeOptions canonize_options(const Context& context) const {
    canonical::CanonizeOptions options;
    options.solve.stop = context.stop;
    options.solve.time_limit = context.seconds_left();
    options.solve.cone_angles = cone_angles;
    return options;
  }
};

Manifold::Manifold(topology::Triangulation triangulation, std::string name, std::string input,
                   bool orientation_known, std::vector<topology::ConeAngle> cone_angles)
    : state_(std::make_shared<const State>(std::move(triangulation), std::move(name),
                                           std::move(input), orientation_known,
                                           std::move(cone_angles))) {
  if (!state_->cone_angles.empty())
    (void)topology::completed(state_->cone_angles, state_->triangulation.edge_count());
}

Manifold::Manifold(topology::Triangulation triangulation, std::string name)
    : Manifold(std::move(triangulation), std::move(name), {}, true) {}

Manifold::Manifold(topology::Gluings gluings, std::string name)
    : Manifold(topology::Triangulation(std::move(gluings)), std::move(name), {}, true) {}

Manifold::Manifold(topology::NamedGluings loaded, std::string input)
    : Manifold(topology::Triangulation(std::move(loaded.gluings)), std::move(loaded.name),
               std::move(input), loaded.orientation_known, std::move(loaded.cone_angles)) {}

Manifold Manifold::with_cone_angles(std::vector<topology::ConeAngle> cone_angles) const {
  std::string plain = split_labels(state_->input).first;
  const std::string labels = topology::labels_text(cone_angles);
  if (!plain.empty() && !labels.empty()) plain += " " + labels;
  return {triangulation(), name(), std::move(plain), state_->orientation_known,
          std::move(cone_angles)};
}

Manifold load(const std::string& input, const Context& context) {
  return Manifold(load_labelled_input(input, Balls::kAllowed, context), input);
}

const std::string& Manifold::name() const { return state_->name; }

const std::string& Manifold::input() const { return state_->input; }

bool Manifold::is_orientation_known() const { return state_->orientation_known; }

std::span<const topology::ConeAngle> Manifold::cone_angles() const { return state_->cone_angles; }

std::string Manifold::label() const {
  if (!state_->input.empty()) return state_->input;
  if (!state_->name.empty()) return state_->name;
  if (!signature() || topology::all_full(cone_angles())) return signature().value_or("");
  if (!triangulation().is_connected()) return *signature();
  return topology::labelled_isosig(triangulation(), cone_angles());
}

const topology::Triangulation& Manifold::triangulation() const { return state_->triangulation; }

std::vector<topology::VertexLink> Manifold::links() const {
  std::vector<topology::VertexLink> result;
  for (std::size_t v = 0; v < triangulation().vertex_count(); ++v)
    result.push_back(triangulation().link(v));
  return result;
}

const std::optional<std::string>& Manifold::signature() const {
  return state_->signature.get([&] {
    return std::pair(topology::isosig(triangulation().gluings(), kSignatureWorkLimit), true);
  });
}

std::optional<std::string> Manifold::oriented_signature() const {
  topology::NamedGluings given{name(), triangulation().gluings()};
  given.orientation_known = is_orientation_known();
  return make_subject({}, std::move(given)).oriented_isosig;
}

const topology::AbelianGroup& Manifold::homology(const Context& context) const {
  return state_->homology.get(
      [&] { return std::pair(topology::first_homology(triangulation(), context.stop), true); });
}

topology::FundamentalGroup Manifold::fundamental_group() const {
  return topology::fundamental_group(triangulation());
}

Manifold Manifold::drilled(const std::vector<std::size_t>& edges,
                           const topology::SimplifyOptions& options, const Context& context) const {
  const auto places = topology::places_to_drill(triangulation(), edges, cone_angles());
  return Manifold(topology::Triangulation(topology::drilled(triangulation().gluings(), places)),
                  name(), {}, state_->orientation_known)
      .simplified(options, context);
}

Manifold Manifold::simplified(const topology::SimplifyOptions& options,
                              const Context& context) const {
  require_plain(*this, "simplifying");
  topology::SimplifyOptions with_stop = options;
  with_stop.stop = context.stop;
  if (!with_stop.progress) with_stop.progress = context.progress;
  // Oriented tables stay oriented.
  topology::Gluings gluings =
      topology::simplify(topology::oriented(triangulation().gluings()), with_stop).gluings;
  return {topology::Triangulation(std::move(gluings)), name(), {}, state_->orientation_known};
}

std::vector<Manifold> Manifold::covers(std::size_t degree, const Context& context) const {
  std::vector<Manifold> result;
  topology::for_each_cover(triangulation(), degree, collect_in(result, *this), context.stop);
  return result;
}

std::vector<Manifold> Manifold::cyclic_covers(std::size_t degree, const Context& context) const {
  std::vector<Manifold> result;
  topology::for_each_cyclic_cover(triangulation(), degree, collect_in(result, *this), context.stop);
  return result;
}

Manifold Manifold::cover(const std::vector<std::vector<std::uint32_t>>& permutations,
                         const Context& context) const {
  return cover_of(*this,
                  topology::cover_of_permutations(triangulation(), permutations, context.stop));
}

structure::Report Manifold::solve(structure::SolveOptions options, const Context& context) const {
  options.stop = context.stop;
  options.time_limit = std::min(options.time_limit, context.seconds_left());
  if (options.cone_angles.empty()) options.cone_angles = state_->cone_angles;
  return structure::solve(triangulation(), options);
}

const structure::Report& Manifold::verdict(const Context& context) const {
  return state_->solve(*this, context).report;
}

const Metric* Manifold::metric(const Context& context) const {
  const State::Solved& solved = state_->solve(*this, context);
  return solved.report.outcome == structure::Outcome::kGeometric ? &solved.metric : nullptr;
}

Manifold Manifold::retriangulated(const structure::RetriangulateOptions& options,
                                  const Context& context) const {
  const structure::Report& start = verdict(context);
  if (start.outcome == structure::Outcome::kGeometric) return *this;
  structure::SolveOptions solve_options;
  solve_options.cone_angles = state_->cone_angles;
  solve_options.stop = context.stop;
  solve_options.time_limit = context.seconds_left();
  structure::Retriangulation found =
      structure::retriangulate(triangulation(), start, solve_options, options);
  Manifold result(topology::Triangulation(std::move(found.gluings)), name(), {},
                  state_->orientation_known, std::move(found.cone_angles));
  // Nothing new was found: the answer says what was tried, and is not looked for again.
  result.state_->solved.get([&] {
    return std::pair(std::make_unique<State::Solved>(*result.state_, std::move(found.report)),
                     true);
  });
  return result;
}

const canonical::CanonizeAnswer& Manifold::canonical(const Context& context) const {
  return state_->canonical.get([&] {
    canonical::CanonizeAnswer answer =
        canonical::canonize(triangulation(), state_->canonize_options(context));
    const bool is_final =
        answer.manifold.has_value() || !(context.stop_requested() || context.expired());
    return std::pair(std::move(answer), is_final);
  });
}

std::optional<std::string> Manifold::isometry_signature(const Context& context) const {
  const canonical::CanonizeAnswer& answer = canonical(context);
  if (!answer.manifold) return std::nullopt;
  return answer.manifold->signature.unoriented;
}

std::optional<canonical::IsometryGroup> Manifold::isometry_group(const Context& context) const {
  const canonical::CanonizeAnswer& answer = canonical(context);
  if (!answer.manifold) return std::nullopt;
  return answer.manifold->isometries;
}

canonical::Comparison Manifold::compare(const Manifold& other, const Context& context) const {
  const bool known = state_->orientation_known && other.state_->orientation_known;
  return canonical::compare(
      {triangulation(), state_->cone_angles}, {other.triangulation(), other.state_->cone_angles},
      state_->canonize_options(context),
      known ? canonical::Orientations::kKnown : canonical::Orientations::kNotKnown);
}

std::optional<bool> Manifold::is_isometric_to(const Manifold& other, const Context& context) const {
  switch (compare(other, context).verdict) {
    case canonical::Verdict::kHomeomorphic:
      return true;
    case canonical::Verdict::kDifferent:
      return false;
    case canonical::Verdict::kUnresolved:
      break;
  }
  return std::nullopt;
}

const canonical::CensusEntry* Manifold::identify(const Context& context) const {
  const canonical::Census& census = canonical::shipped_census();
  if (!topology::all_full(cone_angles())) {
    const std::optional<std::string> found = isometry_signature(context);
    return found ? census.find(*found) : nullptr;
  }
  if (const auto& isosig = signature()) {
    if (const canonical::CensusEntry* entry = census.find(*isosig)) return entry;
  }
  if (const std::optional<std::string> found = isometry_signature(context))
    return census.find(*found);
  return canonical::find_simplified(triangulation(), census, context.stop);
}

std::string Manifold::to_json(const Context& context) const {
  const structure::Report& report = verdict(context);
  return report_as_json({.input = label(),
                         .name = name(),
                         .triangulation = triangulation(),
                         .isosig = signature(),
                         .cone_angles = state_->cone_angles},
                        report);
}

void Manifold::write(const std::string& path, const Context& context) const {
  if (!path.ends_with(".json"))
    throw InvalidInput("cannot write the manifold to " + quoted(path) +
                       ": the name must end with .json");
  write_file(path, to_json(context) + "\n");
}

}  // namespace tripus
