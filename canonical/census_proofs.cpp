#include "canonical/census_proofs.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <map>
#include <mutex>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "canonical/detail/census_lines.hpp"
#include "structure/proof/proof_text.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

/// Digits after the point to which volumes are proved, so that there is no doubt how to round them
/// to those that are shown.
constexpr int kVolumeDigits = 20;
constexpr int kMostRounded = 13;

constexpr std::string_view kHeader = "name\ttriangulation\tlengths\tradius";

std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
  return fields;
}

std::optional<CensusProof> prove_entry(const CensusEntry& entry, const ProveCensusOptions& wanted,
                                       const Context& context) {
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
    CensusProof result{entry.name, signature, std::move(text.lengths),
                       fmt::format("{:.2e}", proof.largest_radius() * 1.01)};
    if (wanted.volumes) {
      const structure::Digits digits =
          structure::prove_digits(triangulation, proof, kVolumeDigits, context);
      if (context.stop_requested() || context.expired()) return std::nullopt;
      result.volume = digits.proved ? digits.volume : text.volume.value();
    }
    return result;
  }
  return std::nullopt;
}

/// number / 10^digits as a decimal number.
std::string decimal(long long number, int digits) {
  std::string text = fmt::format("{:0{}}", number, digits + 1);
  return text.insert(text.size() - static_cast<std::size_t>(digits), ".");
}

/// x * 10^digits rounded to a whole number, halves upwards, for a decimal number x >= 0 without an
/// exponent; nothing for any other text.
std::optional<long long> scaled(std::string_view x, int digits) {
  const std::size_t point = std::min(x.find('.'), x.size());
  std::string text(x.substr(0, point));
  std::string fraction(x.substr(std::min(point + 1, x.size())));
  const auto places = static_cast<std::size_t>(digits);
  fraction.resize(std::max(fraction.size(), places + 1), '0');
  text += fraction.substr(0, places);
  if ((text + fraction).find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  long long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number + (fraction[places] >= '5' ? 1 : 0);
}

/// The decimal number that every number of the interval rounds to, so that it is off by no more
/// than half a unit of its last digit; nothing if there is none.
std::optional<double> common_rounding(const structure::DecimalInterval& interval, int digits) {
  const auto lower = scaled(interval.lower, digits), upper = scaled(interval.upper, digits);
  if (!lower || lower != upper) return std::nullopt;
  return std::stod(decimal(*lower, digits));
}

/// The volume to the digits with which the census prints it: those that are proved, to half a unit
/// of the last; else within one unit of the 13th after the point, or of the 15th in all.
structure::DecimalInterval volume_claim(double volume, int proved_digits) {
  if (proved_digits == 0)
    return {fmt::format("{:.13f}", volume - 1e-13), fmt::format("{:.13f}", volume + 1e-13)};
  const auto number = scaled(fmt::format("{:.{}f}", volume, proved_digits), proved_digits);
  if (!number) throw InvalidInput(fmt::format("no proof can be about the volume {}", volume));
  return {decimal(10 * *number - 5, proved_digits + 1),
          decimal(10 * *number + 5, proved_digits + 1)};
}

/// Why the proof of a manifold is not valid; empty if it is.
std::string objection_to(const CensusEntry& entry, int proved_digits, const CensusProof& proof) {
  if (std::ranges::find(entry.triangulations, proof.triangulation) == entry.triangulations.end())
    return "the census does not list the triangulation " + quoted(proof.triangulation);
  structure::ProofText text;
  text.proved = true;
  text.lengths = proof.lengths;
  text.radii.assign(proof.lengths.size(), proof.radius);
  try {
    text.volume = volume_claim(entry.volume, proved_digits);
    const topology::Triangulation triangulation(topology::decode_isosig(proof.triangulation));
    return structure::check_proof(triangulation, text).reason;
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

}  // namespace

std::vector<CensusProof> prove_census(const Census& census, const ProveCensusOptions& options,
                                      const Context& context) {
  const std::size_t count = census.manifolds.size();
  std::vector<std::optional<CensusProof>> found(count);
  Context alone = context;  // one manifold is too little for several threads
  alone.threads = 1;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t k = next++; k < count && !context.stop_requested() && !context.expired();
           k = next++)
        found[k] = prove_entry(census.manifolds[k], options, alone);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  run_on_threads(thread_count(context.threads), work);
  if (failure) std::rethrow_exception(failure);
  std::vector<CensusProof> proofs;
  for (auto& proof : found)
    if (proof) proofs.push_back(std::move(*proof));
  return proofs;
}

std::vector<std::string> round_to_proved(Census& census, const std::vector<CensusProof>& proofs) {
  double largest = 1;
  std::map<std::string_view, const CensusProof*> by_name;
  for (const CensusProof& proof : proofs) by_name.emplace(proof.name, &proof);
  for (const CensusEntry& entry : census.manifolds) largest = std::max(largest, entry.volume);
  // Rounding may make it longer by a digit.
  const int before_point = static_cast<int>(fmt::format("{:.0f}", std::ceil(largest)).size());
  const int digits = std::min(kMostRounded, detail::kMostProvedDigits - before_point);
  std::vector<std::optional<double>> volumes;
  std::vector<std::string> without;
  for (const CensusEntry& entry : census.manifolds) {
    const auto proof = by_name.find(entry.name);
    const bool proved = proof != by_name.end() && digits > 0;
    volumes.push_back(proved ? common_rounding(proof->second->volume, digits) : std::nullopt);
    if (!volumes.back()) without.push_back(entry.name);
  }
  if (!without.empty()) return without;
  for (std::size_t k = 0; k < volumes.size(); ++k) census.manifolds[k].volume = *volumes[k];
  census.proved_digits = digits;
  return {};
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
      reasons[k] = found == by_name.end()
                       ? "there is no proof of it"
                       : objection_to(census.manifolds[k], census.proved_digits, *found->second);
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
