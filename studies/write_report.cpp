#include "studies/write_report.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/svg_text.hpp"
#include "base/threads.hpp"
#include "base/version.hpp"

namespace tripus::studies {

Machine this_machine() {
  Machine machine{"unknown", thread_count(0), "unknown"};
#if defined(__clang__)
  machine.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
  machine.compiler = "gcc " __VERSION__;
#endif
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      machine.processor = line.substr(colon + 2);
      break;
    }
  }
  return machine;
}

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json table_json(const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.layout().columns) {
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"description", column.description},
                       {"timing", column.timing}});
  }
  return {{"file", table.layout().name + ".csv"},
          {"description", table.layout().description},
          {"rows", table.size()},
          {"columns", columns}};
}

constexpr const char* kStyle = R"(
body{font-family:Helvetica,Arial,sans-serif;max-width:820px;margin:2em auto;padding:0 1em;line-height:1.5;color:#222}
figure{margin:2em 0}figcaption{font-size:.92em;color:#444}svg{max-width:100%;height:auto}
table{border-collapse:collapse;font-size:.9em}td,th{border-bottom:1px solid #ddd;padding:.25em .7em .25em 0;text-align:left;vertical-align:top}
td.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}code{font-size:.95em}
)";

std::string facts_html(const std::vector<Fact>& facts) {
  std::string out = "<table>\n";
  for (const Fact& fact : facts) {
    out +=
        fmt::format("<tr><td>{}</td><td class=\"n\">{}</td></tr>\n", escaped_xml(fact.description),
                    std::isfinite(fact.value) ? fmt::format("{:.8g}", fact.value) : "-");
  }
  return out + "</table>\n";
}

std::string columns_html(const Table& table) {
  std::string out = fmt::format("<h3><code>{}.csv</code></h3>\n<p>{} {} rows.</p>\n<table>\n",
                                escaped_xml(table.layout().name),
                                escaped_xml(table.layout().description), table.size());
  for (const Column& column : table.layout().columns) {
    out += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}{}</td></tr>\n",
                       escaped_xml(column.name), escaped_xml(column.unit),
                       escaped_xml(column.description),
                       column.timing ? " (timing: depends on the machine)" : "");
  }
  return out + "</table>\n";
}

}  // namespace

std::string summary_json(const ReportSource& source) {
  const Machine machine = this_machine();
  Json inputs = Json::array(), tables = Json::array(), facts = Json::object();
  for (const StudyInput& input : source.options.inputs) inputs.push_back(input.name);
  for (const Table& table : source.tables) tables.push_back(table_json(table));
  for (const Fact& fact : source.findings.facts)
    facts[fact.name] = {{"value", number(fact.value)}, {"description", fact.description}};
  const Json summary = {{"tripus", kVersion},
                        {"study", source.study.name},
                        {"seed", source.options.seed},
                        {"samples", source.options.samples},
                        {"methods", source.options.methods},
                        {"covers", source.options.covers},
                        {"machine",
                         {{"processor", machine.processor},
                          {"cores", machine.cores},
                          {"threads", source.threads},
                          {"compiler", machine.compiler}}},
                        {"findings", source.findings.paragraph},
                        {"facts", facts},
                        {"tables", tables},
                        {"inputs", inputs}};
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_html(const ReportSource& source) {
  const Machine machine = this_machine();
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n<p>{2}</p>\n",
      escaped_xml(source.study.title), kStyle, escaped_xml(source.findings.paragraph));
  int k = 0;
  for (const Figure& figure : source.findings.figures) {
    out += fmt::format("<figure>\n{}<figcaption><b>Figure {}.</b> {}</figcaption>\n</figure>\n",
                       to_svg(figure), ++k, escaped_xml(figure.caption));
  }
  out += "<h2>Numbers</h2>\n" + facts_html(source.findings.facts);
  out += "<h2>Data</h2>\n";
  for (const Table& table : source.tables) out += columns_html(table);
  out += fmt::format(
      "<h2>Run</h2>\n<p>Tripus {}, study {}, {} inputs, seed {}, {} {}. {} threads on {} ({} "
      "cores), "
      "compiled with {}.</p>\n</body>\n</html>\n",
      kVersion, source.study.name, source.options.inputs.size(), source.options.seed,
      source.options.samples, escaped_xml(source.study.samples), source.threads,
      escaped_xml(machine.processor), machine.cores, escaped_xml(machine.compiler));
  return out;
}

}  // namespace tripus::studies
