#include "manifold/manifold.hpp"

#include <list>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "canonical/identify.hpp"
#include "manifold/load.hpp"
#include "manifold/report_json.hpp"
#include "manifold/subject.hpp"
#include "topology/drill.hpp"
#include "topology/isosig.hpp"
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

/// Keeps every cover of a search as a manifold.
topology::VisitCover collect_in(std::vector<Manifold>& result) {
  return [&result](const topology::Cover& cover) {
    result.emplace_back(cover.gluings);
    return true;
  };
}

bool was_cut_short(const structure::Report& report) {
  return report.termination == solver::Termination::kInterrupted ||
         report.termination == solver::Termination::kTimeLimit;
}

}  // namespace

/// What copies of a manifold share.
struct Manifold::State {
  State(topology::Triangulation given, std::string given_name, std::string given_input, bool known)
      : triangulation(std::move(given)),
        name(std::move(given_name)),
        input(std::move(given_input)),
        orientation_known(known) {}

  struct Solved {
    Solved(const topology::Triangulation& triangulation, structure::Report found)
        : report(std::move(found)), metric(triangulation, report) {}
    structure::Report report;
    Metric metric;
  };

  topology::Triangulation triangulation;
  std::string name;
  std::string input;
  bool orientation_known;  ///< false for a signature without a sign
  mutable Once<std::optional<std::string>> signature;
  mutable Once<topology::AbelianGroup> homology;
  mutable Once<std::unique_ptr<Solved>> solved;
  mutable Once<canonical::CanonizeAnswer> canonical;

  const Solved& solve(const Manifold& manifold, const Context& context) const {
    return *solved.get([&] {
      auto result = std::make_unique<Solved>(triangulation, manifold.solve({}, context));
      const bool is_final = !was_cut_short(result->report);
      return std::pair(std::move(result), is_final);
    });
  }
};

Manifold::Manifold(topology::Triangulation triangulation, std::string name, std::string input,
                   bool orientation_known)
    : state_(std::make_shared<const State>(std::move(triangulation), std::move(name),
                                           std::move(input), orientation_known)) {}

Manifold::Manifold(topology::Triangulation triangulation, std::string name)
    : Manifold(std::move(triangulation), std::move(name), {}, true) {}

Manifold::Manifold(topology::Gluings gluings, std::string name)
    : Manifold(topology::Triangulation(std::move(gluings)), std::move(name), {}, true) {}

Manifold::Manifold(topology::NamedGluings loaded, std::string input)
    : Manifold(topology::Triangulation(std::move(loaded.gluings)), std::move(loaded.name),
               std::move(input), loaded.orientation_known) {
  if (!topology::all_full(loaded.cone_angles))
    throw Unsupported("a Manifold has no cone angles so far; give them to solve()");
}

Manifold load(const std::string& input, const Context& context) {
  return Manifold(load_input(input, context), input);
}

const std::string& Manifold::name() const { return state_->name; }

const std::string& Manifold::input() const { return state_->input; }

bool Manifold::is_orientation_known() const { return state_->orientation_known; }

std::string Manifold::label() const {
  if (!state_->input.empty()) return state_->input;
  if (!state_->name.empty()) return state_->name;
  return signature().value_or("");
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

const topology::AbelianGroup& Manifold::homology() const {
  return state_->homology.get(
      [&] { return std::pair(topology::first_homology(triangulation()), true); });
}

topology::FundamentalGroup Manifold::fundamental_group() const {
  return topology::fundamental_group(triangulation());
}

Manifold Manifold::drilled(const std::vector<std::size_t>& edges,
                           const topology::SimplifyOptions& options, const Context& context) const {
  const topology::Triangulation& whole = triangulation();
  std::vector<topology::EdgePlace> places;
  for (const std::size_t e : edges) {
    if (e >= whole.edge_count())
      throw InvalidInput(
          fmt::format("there is no edge class {}; there are {}, from 0 on", e, whole.edge_count()));
    const topology::EdgeCorner corner = whole.corners(e)[0];
    places.push_back(
        {static_cast<topology::TetrahedronIndex>(corner.tetrahedron()), corner.edge()});
  }
  return Manifold(topology::Triangulation(topology::drilled(whole.gluings(), places)), name(), {},
                  state_->orientation_known)
      .simplified(options, context);
}

Manifold Manifold::simplified(const topology::SimplifyOptions& options,
                              const Context& context) const {
  const StopFlag stop(context);
  topology::SimplifyOptions with_stop = options;
  with_stop.stop_requested = stop.get();
  if (!with_stop.progress) with_stop.progress = context.progress;
  // Oriented tables stay oriented.
  topology::Gluings gluings =
      topology::simplify(topology::oriented(triangulation().gluings()), with_stop).gluings;
  return {topology::Triangulation(std::move(gluings)), name(), {}, state_->orientation_known};
}

std::vector<Manifold> Manifold::covers(std::size_t degree, const Context& context) const {
  const StopFlag stop(context);
  std::vector<Manifold> result;
  topology::for_each_cover(triangulation(), degree, collect_in(result), stop.get());
  return result;
}

std::vector<Manifold> Manifold::cyclic_covers(std::size_t degree, const Context& context) const {
  const StopFlag stop(context);
  std::vector<Manifold> result;
  topology::for_each_cyclic_cover(triangulation(), degree, collect_in(result), stop.get());
  return result;
}

structure::Report Manifold::solve(structure::SolveOptions options, const Context& context) const {
  const StopFlag stop(context);
  options.stop_requested = stop.get();
  options.time_limit = std::min(options.time_limit, context.seconds_left());
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
  const StopFlag stop(context);
  structure::SolveOptions solve_options;
  solve_options.stop_requested = stop.get();
  solve_options.time_limit = context.seconds_left();
  structure::Retriangulation found =
      structure::retriangulate(triangulation(), start, solve_options, options);
  Manifold result(topology::Triangulation(std::move(found.gluings)), name(), {},
                  state_->orientation_known);
  // Nothing new was found: the answer says what was tried, and is not looked for again.
  result.state_->solved.get([&] {
    return std::pair(
        std::make_unique<State::Solved>(result.triangulation(), std::move(found.report)), true);
  });
  return result;
}

const canonical::CanonizeAnswer& Manifold::canonical(const Context& context) const {
  return state_->canonical.get([&] {
    const StopFlag stop(context);
    canonical::CanonizeOptions options;
    options.solve.stop_requested = stop.get();
    options.solve.time_limit = context.seconds_left();
    canonical::CanonizeAnswer answer = canonical::canonize(triangulation(), options);
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
  const StopFlag stop(context);
  canonical::CanonizeOptions options;
  options.solve.stop_requested = stop.get();
  options.solve.time_limit = context.seconds_left();
  const bool known = state_->orientation_known && other.state_->orientation_known;
  return canonical::compare(
      triangulation(), other.triangulation(), options,
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
  if (const auto& isosig = signature()) {
    if (const canonical::CensusEntry* entry = census.find(*isosig)) return entry;
  }
  if (const std::optional<std::string> found = isometry_signature(context))
    return census.find(*found);
  const StopFlag stop(context);
  return canonical::find_simplified(triangulation(), census, stop.get());
}

std::string Manifold::to_json(const Context& context) const {
  const structure::Report& report = verdict(context);
  return report_as_json({label(), name(), triangulation(), signature()}, report);
}

void Manifold::write(const std::string& path, const Context& context) const {
  if (!path.ends_with(".json"))
    throw InvalidInput("cannot write the manifold to " + quoted(path) +
                       ": the name must end with .json");
  write_file(path, to_json(context) + "\n");
}

}  // namespace tripus
