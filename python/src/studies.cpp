#include <cmath>

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "python/src/bindings.hpp"
#include "studies/study.hpp"

namespace tripus::python {
namespace {

nb::dict table_dict(const studies::Table& table) {
  nb::dict d;
  d["name"] = table.layout().name;
  d["description"] = table.layout().description;
  nb::list columns;
  for (std::size_t c = 0; c < table.layout().columns.size(); ++c) {
    const studies::Column& column = table.layout().columns[c];
    nb::dict about;
    about["name"] = column.name;
    about["unit"] = column.unit;
    about["description"] = column.description;
    about["timing"] = column.timing;
    std::vector<std::string> cells;
    for (const auto& row : table.rows()) cells.push_back(row[c]);
    about["cells"] = cells;
    columns.append(about);
  }
  d["columns"] = columns;
  return d;
}

nb::object limit(double value) {
  if (std::isnan(value)) return nb::none();
  return nb::float_(value);
}

nb::dict axis_dict(const studies::Axis& axis) {
  nb::dict d;
  d["label"] = axis.label;
  d["log"] = axis.log;
  d["lower"] = limit(axis.lower);
  d["upper"] = limit(axis.upper);
  d["categories"] = axis.categories;
  return d;
}

nb::dict figure_dict(const studies::Figure& figure) {
  constexpr const char* kMarks[] = {"line", "point", "line and point", "bar"};
  nb::dict d;
  d["name"] = figure.name;
  d["title"] = figure.title;
  d["caption"] = figure.caption;
  d["x"] = axis_dict(figure.x);
  d["y"] = axis_dict(figure.y);
  nb::list series;
  for (const studies::Series& each : figure.series) {
    nb::dict s;
    s["label"] = each.label;
    s["mark"] = kMarks[std::size_t(each.mark)];
    nb::list points;
    for (const auto& p : each.points) points.append(nb::make_tuple(p[0], p[1]));
    s["points"] = points;
    s["base"] = each.base;
    s["colour"] = each.colour;
    series.append(s);
  }
  d["series"] = series;
  nb::list guides;
  for (const studies::Guide& guide : figure.guides)
    guides.append(nb::make_tuple(guide.vertical, guide.at, guide.label));
  d["guides"] = guides;
  return d;
}

nb::dict result_dict(const studies::RunResult& result) {
  nb::dict d;
  d["done"] = result.done;
  d["total"] = result.total;
  d["paragraph"] = result.paragraph;
  d["files"] = result.files;
  nb::list facts, tables, figures;
  for (const auto& fact : result.facts)
    facts.append(nb::make_tuple(fact.name, fact.value, fact.description));
  for (const auto& table : result.tables) tables.append(table_dict(table));
  for (const auto& figure : result.figures) figures.append(figure_dict(figure));
  d["facts"] = facts;
  d["tables"] = tables;
  d["figures"] = figures;
  return d;
}

nb::dict run_study(const std::string& name, const std::vector<Manifold>& inputs, std::uint64_t seed,
                   std::size_t samples, std::vector<std::string> methods,
                   std::vector<std::size_t> covers, const nb::bytes& folder, const Limits& limits) {
  const std::string place = as_string(folder);
  const studies::Study& study = studies::find_study(name);
  studies::StudyOptions options;
  for (const Manifold& m : inputs)
    options.inputs.push_back({m.label(), m.triangulation().gluings()});
  options.seed = seed;
  options.samples = samples;
  options.methods = std::move(methods);
  options.covers = std::move(covers);
  return result_dict(run(limits, [&](const Context& context) {
    studies::RunOptions how;
    how.folder = place;
    how.threads = std::max(1u, context.threads);
    how.stop = context.stop;
    how.on_progress = [&](std::size_t done, std::size_t) { context.report(name, done); };
    return studies::run_study(study, options, how);
  }));
}

}  // namespace

void bind_studies(nb::module_& module) {
  module.def("study_names", [] {
    nb::list names;
    for (const studies::Study& study : studies::studies())
      names.append(nb::make_tuple(std::string(study.name), std::string(study.title),
                                  std::string(study.description), study.default_samples,
                                  std::string(study.samples)));
    return names;
  });
  module.def("run_study", run_study);
}

}  // namespace tripus::python
