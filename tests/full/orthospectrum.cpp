// The long runs behind docs/orthospectrum.md: brute force on fifty manifolds, and the census.
// scripts/orthospectra runs it.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "tests/support/spectra.hpp"

namespace {

using namespace tripus;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Fifty manifolds with two to four tetrahedra, arcs up to 5 by both methods.
int brute_force() {
  constexpr double kLength = 5;
  std::vector<std::string> names;
  for (const testing::Row& row : testing::compact_manifolds())
    if (names.size() < 158) names.push_back(row.at("isosig"));
  std::vector<std::string> chosen;
  for (std::size_t n = 0; n < names.size(); n += 4) chosen.push_back(names[n]);
  for (const char* name : testing::kNonOrientable) chosen.emplace_back(name);
  const auto larger = testing::data_lines("triangulations-4.txt");
  for (std::size_t n = 0; chosen.size() < 50; n += 211)
    if (testing::try_embed(larger[n])) chosen.push_back(larger[n]);
  fmt::print(
      "| manifold | arcs | cells | brute force, s | unfolding, s | largest difference |\n"
      "|---|---|---|---|---|---|\n");
  int failures = 0;
  double all_slow = 0, all_fast = 0;
  for (const std::string& name : chosen) {
    const auto manifold = testing::try_embed(name);
    auto start = Clock::now();
    std::size_t cells = 0;
    const auto expected =
        testing::counted_by_length(testing::brute_force_arcs(*manifold, kLength, &cells));
    const double slow = seconds_since(start);
    start = Clock::now();
    const auto spectrum = testing::spectrum_of(manifold->triangulation, manifold->report, kLength);
    const double fast = seconds_since(start);
    const auto found = testing::counted_by_length(spectrum);
    double worst = 0;
    bool same = found.size() == expected.size();
    for (std::size_t n = 0; same && n < found.size(); ++n) {
      worst = std::max(worst, std::abs(found[n].length - expected[n].length));
      same = std::abs(found[n].count - expected[n].count) < 1e-9;
    }
    if (!same || worst > 1e-7) ++failures;
    all_slow += slow;
    all_fast += fast;
    fmt::print("| {} | {} | {} | {:.2f} | {:.5f} | {} |\n", name, spectrum.arc_count, cells, slow,
               fast, same ? fmt::format("{:.0e}", worst) : "DIFFERENT");
    std::fflush(stdout);
  }
  fmt::print("\n{} manifolds, {} differ; {:.1f} s by brute force, {:.3f} s by unfolding.\n",
             chosen.size(), failures, all_slow, all_fast);
  return failures == 0 ? 0 : 1;
}

struct Entry {
  std::string name;
  double volume;
  std::vector<testing::LengthCount> lengths;  // the first hundred
};

std::vector<testing::LengthCount> first_lengths(const topology::Triangulation& triangulation,
                                                const structure::Report& report,
                                                std::size_t count) {
  orthospectrum::SpectrumOptions options;
  for (options.count = 20 * count;; options.count *= 2) {
    const auto spectrum = orthospectrum::orthospectrum(triangulation, report.edge_lengths, options);
    auto lengths = testing::counted_by_length(spectrum);
    if (lengths.size() < count) continue;
    lengths.resize(count);
    return lengths;
  }
}

bool is_same(const Entry& a, const Entry& b) {
  for (std::size_t n = 0; n < a.lengths.size(); ++n) {
    if (std::abs(a.lengths[n].length - b.lengths[n].length) > 1e-8 ||
        a.lengths[n].count != b.lengths[n].count)
      return false;
  }
  return true;
}

/// The first ten lengths of all manifolds of the census, and those that share the first hundred.
int census(const std::string& folder, std::size_t most_tetrahedra) {
  std::vector<Entry> entries;
  std::ofstream table(folder + "/orthospectra.tsv");
  table
      << "# The ten shortest lengths of orthogonal arcs of the manifolds of census.tsv, each with "
         "its multiplicity, by scripts/orthospectra census.\nname\tarcs\n";
  const auto start = Clock::now();
  for (const canonical::CensusEntry& manifold : canonical::shipped_census().manifolds) {
    if (manifold.boundary.find_first_of("TK") != std::string::npos) continue;
    if (manifold.tetrahedra > most_tetrahedra) continue;
    std::optional<testing::Embedded> metric;
    for (const std::string& isosig : manifold.triangulations)
      if (!metric) metric = testing::try_embed(isosig);
    Entry entry{manifold.name, manifold.volume, {}};
    if (metric) {
      entry.lengths = first_lengths(metric->triangulation, metric->report, 100);
    } else {
      const auto found = canonical::canonize(
          topology::Triangulation(topology::decode_isosig(manifold.triangulations.front())));
      if (!found.manifold) {
        fmt::print(stderr, "no metric on {}\n", manifold.name);
        return 1;
      }
      entry.lengths = first_lengths(found.manifold->triangulation, found.manifold->report, 100);
    }
    table << entry.name << '\t';
    for (std::size_t n = 0; n < 10; ++n) {
      fmt::print(table, "{}{:.10f}x{:.0f}", n == 0 ? "" : " ", entry.lengths[n].length,
                 entry.lengths[n].count);
    }
    table << '\n';
    entries.push_back(std::move(entry));
  }
  const double seconds = seconds_since(start);
  std::ranges::stable_sort(entries, {}, [](const Entry& e) { return e.volume; });
  std::ofstream shared(folder + "/same-orthospectra.tsv");
  shared
      << "# Manifolds of census.tsv that are not isometric and share the hundred shortest lengths "
         "of orthogonal arcs with their multiplicities, by scripts/orthospectra census.\n"
         "volume\tcount\tnames\n";
  std::vector<char> done(entries.size());
  std::size_t classes = 0, members = 0, pairs = 0, largest = 0, beside = 0;
  for (std::size_t a = 0; a < entries.size(); ++a) {
    if (done[a] != 0) continue;
    std::vector<std::string> names{entries[a].name};
    // Equal spectra have equal volumes, so that those of nearly equal volume are all that may
    // agree.
    for (std::size_t b = a + 1; b < entries.size() && entries[b].volume < entries[a].volume + 1e-6;
         ++b) {
      if (done[b] == 0 && is_same(entries[a], entries[b])) {
        done[b] = 1;
        names.push_back(entries[b].name);
      } else {
        ++beside;
      }
    }
    if (names.size() < 2) continue;
    ++classes;
    members += names.size();
    pairs += names.size() * (names.size() - 1) / 2;
    largest = std::max(largest, names.size());
    fmt::print(shared, "{:.12f}\t{}\t", entries[a].volume, names.size());
    for (std::size_t n = 0; n < names.size(); ++n) shared << (n == 0 ? "" : " ") << names[n];
    shared << '\n';
  }
  fmt::print(
      "{} manifolds in {:.0f} s; {} classes with {} manifolds, {} pairs, the largest of {}; "
      "{} times two of equal volume were told apart.\n",
      entries.size(), seconds, classes, members, pairs, largest, beside);
  return table && shared ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string part = argc > 1 ? argv[1] : "";
  if (part == "brute-force") return brute_force();
  if (part == "census" && argc > 2)
    return census(argv[2], argc > 3 ? std::stoul(argv[3]) : std::size_t{4});
  fmt::print(stderr, "usage: full_orthospectrum brute-force | census FOLDER [TETRAHEDRA]\n");
  return 2;
}
