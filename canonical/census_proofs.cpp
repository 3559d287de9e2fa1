#include "canonical/census_proofs.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "structure/proof/proof_text.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

constexpr std::string_view kHeader = "name\ttriangulation\tlengths\tradius";

std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
  return fields;
}

std::optional<CensusProof> prove_entry(const CensusEntry& entry, const Context& context) {
  structure::SolveOptions options;
  options.evidence = false;
  for (const std::string& signature : entry.triangulations) {
    const topology::Triangulation triangulation(topology::decode_isosig(signature));
    const structure::Report report = structure::solve(triangulation, options);
    if (report.outcome != structure::Outcome::kGeometric) continue;
    const structure::Proof proof =
        structure::prove(triangulation, report.edge_lengths, {}, context);
    if (!proof.proved) continue;
    structure::ProofText text = structure::proof_text(proof);
    return CensusProof{entry.name, signature, std::move(text.lengths),
                       fmt::format("{:.2e}", proof.largest_radius() * 1.01)};
  }
  return std::nullopt;
}

/// The volume to the digits with which the census prints it: within one unit of the 13th after the
/// point, or of the 15th in all.
structure::DecimalInterval volume_claim(double volume) {
  return {fmt::format("{:.13f}", volume - 1e-13), fmt::format("{:.13f}", volume + 1e-13)};
}

/// Why the proof of a manifold is not valid; empty if it is.
std::string objection_to(const CensusEntry& entry, const CensusProof& proof) {
  if (std::ranges::find(entry.triangulations, proof.triangulation) == entry.triangulations.end())
    return "the census does not list the triangulation " + quoted(proof.triangulation);
  structure::ProofText text;
  text.proved = true;
  text.lengths = proof.lengths;
  text.radii.assign(proof.lengths.size(), proof.radius);
  text.volume = volume_claim(entry.volume);
  try {
    const topology::Triangulation triangulation(topology::decode_isosig(proof.triangulation));
    return structure::check_proof(triangulation, text).reason;
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

}  // namespace

std::vector<CensusProof> prove_census(const Census& census, const Context& context) {
  std::vector<CensusProof> proofs;
  for (const CensusEntry& entry : census.manifolds) {
    if (context.stop_requested()) break;
    if (auto proof = prove_entry(entry, context)) proofs.push_back(std::move(*proof));
  }
  return proofs;
}

std::string to_tsv(const std::vector<CensusProof>& proofs) {
  std::string text =
      "# Proofs of the metrics of a census, for tripus census --check: docs/proof.md.\n";
  text += kHeader;
  text += '\n';
  for (const CensusProof& proof : proofs)
    text += fmt::format("{}\t{}\t{}\t{}\n", proof.name, proof.triangulation,
                        fmt::join(proof.lengths, ","), proof.radius);
  return text;
}

std::vector<CensusProof> parse_census_proofs(std::string_view text) {
  std::vector<CensusProof> proofs;
  std::istringstream in{std::string(text)};
  std::size_t number = 0;
  bool header = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (!header) {
      if (line != kHeader)
        throw InvalidInput(fmt::format("line {}: expected the header \"{}\"", number, kHeader));
      header = true;
      continue;
    }
    auto fields = fields_of(line, '\t');
    if (fields.size() != 4)
      throw InvalidInput(fmt::format("line {}: {} fields, expected 4", number, fields.size()));
    proofs.push_back({std::move(fields[0]), std::move(fields[1]), fields_of(fields[2], ','),
                      std::move(fields[3])});
  }
  return proofs;
}

CensusCheck check_census(const Census& census, const std::vector<CensusProof>& proofs,
                         const Context& context) {
  std::map<std::string_view, const CensusProof*> by_name;
  for (const CensusProof& proof : proofs) by_name.emplace(proof.name, &proof);
  const std::size_t count = census.manifolds.size();
  std::vector<std::string> reasons(count);
  std::vector<char> done(count);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < count && !context.stop_requested(); k = next++) {
      const auto found = by_name.find(census.manifolds[k].name);
      reasons[k] = found == by_name.end() ? "there is no proof of it"
                                          : objection_to(census.manifolds[k], *found->second);
      done[k] = 1;
    }
  };
  run_on_threads(thread_count(context.threads), work);
  CensusCheck result;
  for (std::size_t k = 0; k < count; ++k) {
    if (done[k] == 0)
      result.stopped = true;
    else if (reasons[k].empty())
      ++result.valid;
    else
      result.failures.push_back(census.manifolds[k].name + ": " + reasons[k]);
  }
  return result;
}

}  // namespace tripus::canonical
