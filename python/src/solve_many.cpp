#include <algorithm>
#include <atomic>
#include <limits>

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "base/threads.hpp"
#include "manifold/prepared.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"

namespace tripus::python {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// One answer; the error of an input that is refused goes into its message.
struct Row {
  std::string outcome = "unresolved";
  std::string message = "not reached before the time limit";
  std::size_t tetrahedra = 0;
  double volume = kNoNumber;
  double max_curvature = kNoNumber;
  double seconds = 0;
  double lower = kNoNumber, upper = kNoNumber;
  std::int64_t iterations = 0;
  bool done = false;
};

/// An INPUT as text, or a manifold that is there already.
struct Question {
  std::string input;
  std::optional<Manifold> manifold;
};

void fill(Row& row, const topology::Triangulation& triangulation, const structure::Report& report,
          std::span<const topology::ConeAngle> cone_angles, bool prove, const Context& context) {
  row.outcome = structure::to_string(report.outcome);
  row.message = report.message;
  row.tetrahedra = triangulation.tetrahedron_count();
  if (report.outcome == structure::Outcome::kGeometric) row.volume = report.volume;
  row.max_curvature = report.max_curvature;
  row.seconds = report.seconds;
  row.iterations = report.iterations;
  if (!prove || report.outcome != structure::Outcome::kGeometric) return;
  const structure::Proof proof = Metric(triangulation, report, cone_angles).prove(context);
  if (!proof.proved) {
    row.message = "not proved: " + proof.reason;
    return;
  }
  row.lower = proof.volume.lower;
  row.upper = proof.volume.upper;
}

/// As a line of `tripus solve --batch`, labels included.
void answer_text(Row& row, const std::string& input, bool prove, const Context& context) {
  topology::NamedGluings loaded = load_labelled_input(input, Balls::kRefused, context);
  if (loaded.cone_angles.empty())
    make_ideal(loaded, topology::FiniteVertices::kRemove, context.stop);
  const topology::Triangulation triangulation(std::move(loaded.gluings));
  structure::SolveOptions options;
  options.cone_angles = std::move(loaded.cone_angles);
  options.stop = context.stop;
  options.time_limit = context.seconds_left();
  fill(row, triangulation, structure::solve(triangulation, options), options.cone_angles, prove,
       context);
}

Row answer(const Question& question, bool prove, const Context& context) {
  Row row;
  row.done = true;
  try {
    if (question.manifold) {
      const Manifold& manifold = *question.manifold;
      fill(row, manifold.triangulation(), manifold.verdict(context), manifold.cone_angles(), prove,
           context);
    } else {
      answer_text(row, question.input, prove, context);
    }
  } catch (const Error& error) {
    row.outcome = "error";
    row.message = error.what();
  }
  return row;
}

/// Answers in the order of the questions, by so many threads.
std::vector<Row> answers(const std::vector<Question>& questions, bool prove,
                         const Context& context) {
  std::vector<Row> rows(questions.size());
  const auto threads = unsigned(std::min<std::size_t>(thread_count(context.threads),
                                                      std::max<std::size_t>(1, questions.size())));
  std::atomic<std::size_t> next{0}, done{0};
  Context each = context;
  each.threads = 1;
  each.progress = {};
  each.note = {};
  const auto work = [&](bool tells) {
    for (std::size_t i = next++; i < questions.size(); i = next++) {
      if (context.stop_requested() || context.expired()) return;
      rows[i] = answer(questions[i], prove, each);
      if (++done; tells && done % 64 < threads) context.report("solve", done);
    }
  };
  {
    const auto in_silence = [&] { work(false); };
    const auto others = start_threads(threads - 1, in_silence);
    work(true);
  }
  context.report("solve", done);
  return rows;
}

template <class Get>
auto column(const std::vector<Row>& rows, Get&& get) {
  using Value = std::decay_t<std::invoke_result_t<Get&, const Row&>>;
  std::vector<Value> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(get(row));
  return values;
}

nb::dict solve_many(const nb::list& inputs, bool prove, const Limits& limits) {
  std::vector<Question> questions;
  questions.reserve(inputs.size());
  for (const nb::handle each : inputs) {
    if (nb::isinstance<Manifold>(each)) {
      questions.push_back({{}, nb::cast<Manifold>(each)});
    } else {
      questions.push_back({as_string(nb::cast<nb::bytes>(each)), {}});
    }
  }
  const std::vector<Row> rows =
      run(limits, [&](const Context& context) { return answers(questions, prove, context); });
  nb::dict d;
  d["outcome"] = column(rows, [](const Row& r) { return r.outcome; });
  d["volume"] = owned(column(rows, [](const Row& r) { return r.volume; }));
  d["tetrahedra"] = owned(column(rows, [](const Row& r) { return std::int64_t(r.tetrahedra); }));
  d["max_curvature"] = owned(column(rows, [](const Row& r) { return r.max_curvature; }));
  d["iterations"] = owned(column(rows, [](const Row& r) { return r.iterations; }));
  d["seconds"] = owned(column(rows, [](const Row& r) { return r.seconds; }));
  if (prove) {
    d["volume_lower"] = owned(column(rows, [](const Row& r) { return r.lower; }));
    d["volume_upper"] = owned(column(rows, [](const Row& r) { return r.upper; }));
  }
  nb::list messages;
  for (const Row& row : rows) messages.append(as_bytes(row.message));
  d["message"] = messages;
  return d;
}

}  // namespace

void bind_solve_many(nb::module_& module) { module.def("solve_many", solve_many); }

}  // namespace tripus::python
