// The tripus: lengths and multiplicities found by a prototype that unfolds whole cells with numpy
// and knows no windows.
#include <atomic>
#include <cmath>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

#include "orthospectrum/detail/unfold.hpp"
#include "orthospectrum/identities.hpp"
#include "tests/support/spectra.hpp"

namespace tripus::orthospectrum {
namespace {

TEST(OrthospectrumTripus, ShortestLengthsAndMultiplicities) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const Spectrum spectrum = testing::spectrum_of(tripus.triangulation, tripus.report, 6);
  EXPECT_EQ(spectrum.arc_count, 527u);
  ASSERT_EQ(spectrum.arcs.size(), 527u);
  const auto counts = testing::counted_by_length(spectrum);
  constexpr double kLengths[] = {0.596133894891, 2.65493, 3.41955, 3.84719,
                                 4.07404,        4.14569, 4.37524, 4.91198};
  constexpr double kMultiplicities[] = {1, 4, 12, 12, 12, 6, 24, 48};
  for (std::size_t n = 0; n < std::size(kLengths); ++n) {
    EXPECT_NEAR(counts[n].length, kLengths[n], n == 0 ? 1e-12 : 6e-6);
    EXPECT_EQ(counts[n].count, kMultiplicities[n]);
  }
  EXPECT_EQ(spectrum.arcs.front().edge, 0u);
}

TEST(OrthospectrumTripus, EachMoreArcIsFoundOnce) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const auto longer =
      testing::lengths_of(testing::spectrum_of(tripus.triangulation, tripus.report, 7));
  EXPECT_EQ(longer.size(), 2267u);
  for (const double length : {0.5, 0.6, 3.0, 5.5, 6.0, 6.7}) {
    const auto shorter =
        testing::lengths_of(testing::spectrum_of(tripus.triangulation, tripus.report, length));
    ASSERT_LE(shorter.size(), longer.size());
    for (std::size_t n = 0; n < shorter.size(); ++n) ASSERT_NEAR(shorter[n], longer[n], 1e-12);
    EXPECT_GT(longer[shorter.size()], length);
  }
}

/// The tetrahedra of the tripus are regular: beyond each face lies the mirror image. With the
/// products with the four vertices that is w' = 2 b (w_1 + w_2 + w_3) - w_0, b = a / (2 a - 1),
/// a = cosh l = cos 30 / (2 cos 30 - 1); here in 50 digits.
TEST(OrthospectrumTripus, LengthsNear15AreGoodTo1em10) {
  using Wide = boost::multiprecision::cpp_dec_float_50;
  const Wide cosine = sqrt(Wide(3)) / 2, a = cosine / (2 * cosine - 1), b = a / (2 * a - 1);
  const testing::Embedded tripus = testing::embedded_tripus();
  const topology::Gluings& gluings = tripus.triangulation.gluings();
  const detail::Steps steps(tripus.triangulation, tripus.report.edge_lengths);
  const double shortest = tripus.report.edge_lengths[0];
  const detail::Reach reach(15, shortest);
  const auto lids = steps.lids(shortest);
  detail::Unfolding unfolding(steps, reach, lids);
  std::size_t found = 0, near_15 = 0;
  double worst = 0;
  std::atomic<bool> enough = false;
  Context context;
  context.stop = &enough;
  detail::Halt halt(context);
  const auto check = [&](const detail::Find& find) {
    if (++found == 20000) enough = true;
    if (find.length < 14 || found > 20000) return;
    ++near_15;
    std::array<Wide, 4> products{-a, -a, -a, -a};
    products[0] = 1;  // the search is from vertex 0 of tetrahedron 0
    std::size_t t = 0;
    int last = 0;
    for (const int face : find.faces) {
      std::array<Wide, 4> next;
      Wide sum = 0;
      const topology::Perm4 p = gluings.gluing(t, face);
      for (int i = 0; i < 4; ++i) {
        next[static_cast<std::size_t>(p(i))] = products[static_cast<std::size_t>(i)];
        if (i != face) sum += products[static_cast<std::size_t>(i)];
      }
      last = p(face);
      next[static_cast<std::size_t>(last)] = 2 * b * sum - products[static_cast<std::size_t>(face)];
      products = next;
      t = gluings.neighbour(t, face);
    }
    const Wide exact = acosh(Wide(-products[static_cast<std::size_t>(last)]));
    worst = std::max(worst, std::abs(static_cast<double>(exact - find.length)));
  };
  EXPECT_FALSE(unfolding.search(0, 0, check, halt));
  EXPECT_GT(near_15, 5000u);
  EXPECT_LT(worst, 1e-10);
  RecordProperty("worst", std::to_string(worst));
}

TEST(OrthospectrumTripus, VolumeByArcsAndTheAreaAlone) {
  const testing::Embedded tripus = testing::embedded_tripus();
  SpectrumOptions options;
  options.length = 9;
  options.keep_arcs = false;
  const Spectrum spectrum =
      orthospectrum(tripus.triangulation, tripus.report.edge_lengths, options);
  const Identities found =
      identities_of(spectrum.sums, spectrum.length, 12.566370614359172, 6.45199027083503287);
  ASSERT_TRUE(found.volume_from_area);
  EXPECT_NEAR(found.volume_from_area->value, 6.45199027083503287,
              found.volume_from_area->uncertainty);
  EXPECT_LT(found.volume_from_area->uncertainty, 1e-3);
}

}  // namespace
}  // namespace tripus::orthospectrum
