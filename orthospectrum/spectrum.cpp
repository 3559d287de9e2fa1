#include "orthospectrum/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "base/tolerances.hpp"
#include "orthospectrum/detail/stage.hpp"

namespace tripus::orthospectrum {
namespace {

using detail::Stage;

/// A stage finds about so many times as many arcs as the one before, at most: the last is nearly
/// all of the work, and an interruption still leaves something.
constexpr double kStageRatio = 30;
/// Fewer arcs than this cost nothing, and say little about how many there will be.
constexpr double kFewArcs = 1000;
/// Limit sets of dimension 2 and more there are none.
constexpr double kLargestDimension = 2;

void require_options(const SpectrumOptions& options) {
  const bool by_length = options.length != 0;
  if (by_length == (options.count != 0))
    throw InvalidInput("either a length or a number of arcs bounds an orthospectrum");
  if (by_length && !(options.length > 0 && options.length <= kLongestArc)) {
    throw InvalidInput(
        fmt::format("the length {} is not greater than 0 and at most {}: feet of longer arcs are "
                    "too close for double precision",
                    options.length, kLongestArc));
  }
}

/// Chooses the lengths of the stages.
class Schedule {
 public:
  Schedule(const SpectrumOptions& options, double first)
      : options_(options), length_(options.length != 0 ? std::min(first, options.length) : first) {}

  double length() const { return length_; }

  /// Whether `stage` is the last; otherwise length() has the next one.
  /// Throws TooManyArcs, and InvalidInput where there are fewer than `count` arcs in reach.
  bool ends_with(const Stage& stage) {
    const double count = static_cast<double>(stage.sums.oriented_count()) / 2;
    if (last_count_ >= kFewArcs / 10 && count > last_count_)
      growth_ =
          std::min(kLargestDimension, std::log(count / last_count_) / (length_ - last_length_));
    if (options_.count != 0) return ends_with_count(count);
    if (length_ >= options_.length) return true;
    const double left = options_.length - length_;
    if (count >= kFewArcs) {
      const double estimate = count * std::exp(growth_ * left);
      if (!accepted_ && estimate > options_.most_arcs) throw TooManyArcs(options_.length, estimate);
      accepted_ = true;
    }
    const bool jump = count > 0 && count * std::exp(growth_ * left) <= 10 * kFewArcs;
    const double part = jump ? left : step(count, left);
    go_to(part < left ? length_ + part : options_.length, count);
    return false;
  }

 private:
  /// The way to go is divided evenly: a stage just before the last would be done in vain.
  double step(double count, double left) const {
    if (count < kFewArcs / 10) return 1;
    return left / std::max(1.0, std::ceil(growth_ * left / std::log(kStageRatio)));
  }

  bool ends_with_count(double count) {
    const auto wanted = static_cast<double>(options_.count);
    if (count >= wanted) return true;
    if (wanted > options_.most_arcs) throw TooManyArcs(0, wanted);
    if (length_ >= kLongestArc) {
      throw InvalidInput("only " + std::to_string(static_cast<std::uint64_t>(count)) +
                         " arcs are shorter than " + std::to_string(static_cast<int>(kLongestArc)) +
                         ", not " + std::to_string(options_.count));
    }
    // Aim a little further than the estimate: a second try costs more than a few arcs too many.
    constexpr double kMore = 0.1;
    const double aim = count >= kFewArcs / 10 ? std::log(wanted / count) / growth_ + kMore : 1;
    go_to(std::min(kLongestArc, length_ + step(count, aim)), count);
    return false;
  }

  void go_to(double length, double count) {
    last_length_ = length_;
    last_count_ = count;
    length_ = length;
  }

  const SpectrumOptions& options_;
  double length_;
  double last_length_ = 0, last_count_ = 0;
  double growth_ = 1.5;
  bool accepted_ = false;
};

/// Leaves the shortest `count` arcs, and those as long as the last of them.
void cut_to_count(Spectrum& spectrum, std::size_t count) {
  std::size_t end = count;
  while (end < spectrum.arcs.size() &&
         spectrum.arcs[end].length - spectrum.arcs[end - 1].length <= tolerance::kSameArcLength)
    ++end;
  // Complete up to the last of them, and not further.
  spectrum.length = spectrum.arcs[end - 1].length;
  spectrum.arcs.resize(end);
  spectrum.arc_count = end;
  spectrum.sums = Sums();
  for (const Arc& arc : spectrum.arcs) {
    spectrum.sums.add(arc.length);
    spectrum.sums.add(arc.length);
  }
}

void sort_arcs(Stage& stage) {
  std::ranges::stable_sort(stage.arcs, {}, [](const Arc& arc) { return arc.length; });
}

}  // namespace

TooManyArcs::TooManyArcs(double bound, double arcs)
    : InvalidInput("there would be about " + detail::rounded(arcs) + " arcs" +
                   (bound > 0 ? " up to the length " + detail::rounded(bound) : std::string())),
      length(bound),
      estimate(arcs) {}

Spectrum orthospectrum(const topology::Triangulation& triangulation,
                       std::span<const double> edge_lengths, const SpectrumOptions& options,
                       const Context& context) {
  require_options(options);
  detail::Halt halt(context);
  detail::StageRunner runner(triangulation, edge_lengths, options, context.threads, halt);
  Schedule schedule(options, std::min(kLongestArc, runner.first_length()));
  Spectrum spectrum;
  Stage last;
  bool done = false;
  while (!done) {
    std::optional<Stage> stage = runner.run(schedule.length());
    spectrum.windows = runner.window_count();
    if (!stage) break;
    last = std::move(*stage);
    spectrum.length = schedule.length();
    context.report(detail::stage_text(spectrum.length, last.sums.oriented_count() / 2));
    done = schedule.ends_with(last);
  }
  if (!done) {
    spectrum.end =
        halt.reason() == detail::Halt::kTime ? SpectrumEnd::kTimeLimit : SpectrumEnd::kInterrupted;
  }
  sort_arcs(last);
  spectrum.arcs = std::move(last.arcs);
  spectrum.faces = std::move(last.faces);
  spectrum.sums = std::move(last.sums);
  spectrum.arc_count = spectrum.sums.oriented_count() / 2;
  if (done && options.count != 0 && options.keep_arcs) cut_to_count(spectrum, options.count);
  return spectrum;
}

std::vector<double> shortest_lengths(const topology::Triangulation& triangulation,
                                     std::span<const double> edge_lengths, std::size_t count,
                                     const Context& context) {
  SpectrumOptions options;
  options.count = count;
  const Spectrum spectrum = orthospectrum(triangulation, edge_lengths, options, context);
  std::vector<double> lengths;
  for (const Arc& arc : spectrum.arcs)
    if (lengths.size() < count) lengths.push_back(arc.length);
  return lengths;
}

Grouping group_arcs(const Spectrum& spectrum, const topology::Triangulation& triangulation) {
  Grouping result;
  const std::vector<Arc>& arcs = spectrum.arcs;
  const auto ends_of = [&](std::size_t n) {
    std::array<std::uint32_t, 2> ends{
        triangulation.vertex_class(arcs[n].start.tile.tetrahedron,
                                   static_cast<int>(arcs[n].start.tile.vertex)),
        triangulation.vertex_class(arcs[n].end.tile.tetrahedron,
                                   static_cast<int>(arcs[n].end.tile.vertex))};
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    return ends;
  };
  result.order.resize(arcs.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t{0});
  for (std::size_t first = 0, last = 0; first < arcs.size(); first = last) {
    for (last = first + 1; last < arcs.size() &&
                           arcs[last].length - arcs[last - 1].length <= tolerance::kSameArcLength;)
      ++last;
    std::ranges::stable_sort(std::span(result.order).subspan(first, last - first), {}, ends_of);
    for (std::size_t n = first; n < last; ++n) {
      const auto ends = ends_of(result.order[n]);
      if (n == first || ends != result.groups.back().ends)
        result.groups.push_back({arcs[first].length, ends, n, 0});
      ++result.groups.back().multiplicity;
    }
  }
  return result;
}

double cosh_along(const topology::Triangulation& triangulation,
                  std::span<const double> edge_lengths, Tile start,
                  std::span<const std::uint8_t> faces, Tile end) {
  const detail::Steps steps(triangulation, edge_lengths);
  std::size_t t = start.tetrahedron;
  std::array<double, 4> products{};
  for (int j = 0; j < 4; ++j)
    products[static_cast<std::size_t>(j)] =
        -steps.cosh_length(t, static_cast<int>(start.vertex), j);
  for (const std::uint8_t face : faces) {
    const detail::Step& step = steps.step(t, face);
    products = detail::carried(step, face, products);
    t = step.tetrahedron;
  }
  if (t != end.tetrahedron) throw InvalidInput("the faces do not lead to the end of the arc");
  return -products[end.vertex];
}

}  // namespace tripus::orthospectrum
