#include "structure/proof/prove_report.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

namespace tripus::structure {
namespace {

constexpr std::size_t kDigitsShown = 60;

/// What two decimal numbers have in common, with dots where more follows.
std::string common_digits(const DecimalInterval& interval) {
  const auto [a, b] = std::ranges::mismatch(interval.lower, interval.upper);
  std::string common(interval.lower.begin(), a);
  if (common.find('.') == std::string::npos)
    return fmt::format("from {} to {}", interval.lower, interval.upper);
  if (common.size() > kDigitsShown)
    return fmt::format("{}... ({} digits proved)", common.substr(0, kDigitsShown),
                       common.size() - common.find('.') - 1);
  return common + "...";
}

}  // namespace

ProofText prove_report(const topology::Triangulation& triangulation, const Report& report,
                       const ProveReportOptions& options, const Context& context) {
  ProveOptions prove_options;
  prove_options.cone_angles = options.cone_angles;
  if (report.outcome == Outcome::kGeometric) {
    const Proof proof = prove_near(triangulation, report.edge_lengths, prove_options, context);
    if (options.digits == 0 || !proof.proved) return proof_text(proof);
    const Digits found = prove_digits(triangulation, proof, options.digits, context);
    return proof_text(proof, &found);
  }
  if (report.outcome == Outcome::kDegenerate) {
    prove_options.volume = false;
    prove_options.flat = report.flat_tetrahedra;
    return proof_text(prove(triangulation, report.edge_lengths, prove_options, context));
  }
  ProofText none;
  none.reason = report.certificate
                    ? "there is no metric, which the certificate proves by integer arithmetic"
                    : "no metric was found, so there is nothing to prove";
  return none;
}

std::string proof_message(const ProofText& proof) {
  if (!proof.proved) return "Not proved: " + proof.reason + ".";
  std::string text;
  if (proof.claim == Proof::Claim::kFlat) {
    text = fmt::format(
        "Proved: the co-volume is least where {} of the tetrahedra {} flat, so this triangulation "
        "carries no metric; its manifold may.",
        proof.flat.size(), proof.flat.size() == 1 ? "is" : "are");
  } else {
    const auto widest = std::ranges::max_element(proof.radii, {}, [](const std::string& radius) {
      return std::strtold(radius.c_str(), nullptr);
    });
    text = fmt::format(
        "Proved: this triangulation carries the hyperbolic metric{}; each length to within {}",
        proof.cone_angles.empty() ? "" : " with these cone angles",
        widest == proof.radii.end() ? "0" : *widest);
    if (proof.volume) text += "; volume " + common_digits(*proof.volume);
    text += ".";
  }
  if (proof.escalated > 0)
    text += fmt::format(" {} of the tetrahedra needed {} bits.", proof.escalated, proof.bits);
  return text;
}

}  // namespace tripus::structure
