// Canonical signatures of triangulations with five tetrahedra, of their relabellings, and of what
// ten random moves make of them. Run by scripts/signatures.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/in_order.hpp"
#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "topology/enumerate.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace {

using namespace tripus;
using topology::Gluings;

/// All with so many tetrahedra and geodesic boundary, in a random order.
std::vector<std::string> shuffled_list(std::size_t tetrahedra, std::mt19937_64& random) {
  std::vector<std::string> list;
  for (const auto& piece :
       topology::enumeration_pieces(tetrahedra, topology::LinkChoice::kGeodesic))
    topology::enumerate(
        tetrahedra, topology::LinkChoice::kGeodesic, piece,
        [&](const Gluings& gluings, unsigned) { list.push_back(topology::isosig(gluings)); });
  std::shuffle(list.begin(), list.end(), random);
  return list;
}

std::optional<canonical::CanonicalManifold> canonized(const Gluings& gluings, std::size_t budget) {
  canonical::CanonizeOptions options;
  options.retriangulation.budget = budget;
  return canonical::canonize(topology::Triangulation(gluings), options).manifold;
}

/// What became of one triangulation.
struct Trial {
  bool has_signature = false;
  bool relabelled = false, moved = false;  ///< the same signature after
  std::size_t moved_size = 0;              ///< tetrahedra after the moves
  std::string complaints;
};

Trial attempt(const std::string& signature, std::size_t moves, std::uint64_t seed) {
  constexpr std::size_t kLargerBudget = 500;
  Trial trial;
  const Gluings gluings = topology::decode_isosig(signature);
  const auto manifold = canonized(gluings, canonical::kCensusBudget);
  if (!manifold) return trial;
  trial.has_signature = true;
  const auto same = [&](const Gluings& other, std::size_t budget, const char* what) {
    const auto found = canonized(other, budget);
    if (found && found->signature.unoriented == manifold->signature.unoriented &&
        found->order.code == manifold->order.code)
      return true;
    trial.complaints +=
        fmt::format("{}: {}: {}: {}\n", signature, what,
                    found ? "another signature" : "no signature found", topology::isosig(other));
    return false;
  };
  const std::size_t tetrahedra = gluings.tetrahedron_count();
  trial.relabelled =
      same(topology::relabelled(gluings, topology::random_isomorphism(tetrahedra, seed)),
           canonical::kCensusBudget, "relabelled");
  Gluings walked = gluings;
  topology::randomize(walked, {.count = moves, .seed = seed, .max_tetrahedra = tetrahedra + 4});
  trial.moved_size = walked.tetrahedron_count();
  trial.moved = same(walked, kLargerBudget, "moved");
  return trial;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto tetrahedra = static_cast<std::size_t>(std::atoi(argv[1]));
  const auto wanted = static_cast<std::size_t>(std::atoi(argv[2]));
  const auto moves = static_cast<std::size_t>(std::atoi(argv[3]));
  std::mt19937_64 random(static_cast<std::uint64_t>(std::atoi(argv[4])));

  const auto start = std::chrono::steady_clock::now();
  const auto list = shuffled_list(tetrahedra, random);
  const std::uint64_t first_seed = random();
  std::size_t drawn = 0, tried = 0, relabelled = 0, moved = 0;
  std::map<std::size_t, std::size_t> sizes;
  in_order(
      list.size(), thread_count(0),
      [&](std::size_t k) -> std::optional<Trial> {
        return attempt(list[k], moves, first_seed + k);
      },
      [&](std::size_t, const Trial& trial) {
        ++drawn;
        if (!trial.has_signature) return true;
        relabelled += trial.relabelled;
        moved += trial.moved;
        ++sizes[trial.moved_size];
        std::fputs(trial.complaints.c_str(), stdout);
        return ++tried < wanted;
      });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  fmt::print(
      "{} triangulations with {} tetrahedra drawn, {} with a canonical signature; the same after "
      "relabelling: {}, after {} random moves: {}; {:.0f} s\n",
      drawn, tetrahedra, tried, relabelled, moves, moved, seconds.count());
  for (const auto& [size, count] : sizes)
    fmt::print("  {} tetrahedra after the moves: {}\n", size, count);
  return tried == wanted && relabelled == tried && moved == tried ? 0 : 1;
}
