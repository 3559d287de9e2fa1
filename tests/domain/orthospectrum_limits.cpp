// Orthospectra at the edge of what can be asked: refused by name, ended with what is complete.
#include <atomic>
#include <chrono>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/spectra.hpp"

namespace tripus::orthospectrum {
namespace {

using testing::Embedded;

Spectrum find(const Embedded& manifold, const SpectrumOptions& options,
              const Context& context = {}) {
  return orthospectrum(manifold.triangulation, manifold.report.edge_lengths, options, context);
}

TEST(OrthospectrumLimits, RefusesWhatCannotBe) {
  const Embedded tripus = testing::embedded_tripus();
  SpectrumOptions options;
  EXPECT_THROW(find(tripus, options), InvalidInput);  // no bound
  options.length = 3;
  options.count = 3;
  EXPECT_THROW(find(tripus, options), InvalidInput);  // two
  options.count = 0;
  for (const double length : {-1.0, 20.5, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    options.length = length;
    EXPECT_THROW(find(tripus, options), InvalidInput) << length;
  }
  options.length = 3;
  const std::vector<double> two{0.6, 0.6}, flat{3.0};
  EXPECT_THROW(orthospectrum(tripus.triangulation, two, options), InvalidInput);
  const topology::Triangulation many(topology::decode_isosig("dLQbcbcdhjw"));
  EXPECT_THROW(orthospectrum(many, std::vector<double>(many.edge_count(), -1.0), options),
               InvalidInput);
}

TEST(OrthospectrumLimits, TooManyArcsAreEstimatedFirst) {
  const Embedded tripus = testing::embedded_tripus();
  SpectrumOptions options;
  options.length = 18;
  try {
    find(tripus, options);
    FAIL() << "10^10 arcs were found";
  } catch (const TooManyArcs& error) {
    EXPECT_EQ(error.length, 18);
    // From 169,547 up to 10 with the exponent 1.45.
    EXPECT_GT(error.estimate, 5e9);
    EXPECT_LT(error.estimate, 8e10);
    EXPECT_NE(std::string(error.what()).find("arcs"), std::string::npos);
  }
  options.length = 0;
  options.count = 2'000'000'000;
  EXPECT_THROW(find(tripus, options), TooManyArcs);
}

TEST(OrthospectrumLimits, ATimeLimitLeavesWhatIsComplete) {
  const Embedded tripus = testing::embedded_tripus();
  SpectrumOptions options;
  options.length = 19;
  options.most_arcs = std::numeric_limits<double>::infinity();
  Context context;
  context.deadline = Context::Clock::now() + std::chrono::milliseconds(200);
  const Spectrum spectrum = find(tripus, options, context);
  EXPECT_EQ(spectrum.end, SpectrumEnd::kTimeLimit);
  EXPECT_LT(spectrum.length, 19);
  EXPECT_EQ(spectrum.arcs.size(), spectrum.arc_count);
  EXPECT_EQ(testing::lengths_of(spectrum),
            testing::lengths_of(
                testing::spectrum_of(tripus.triangulation, tripus.report, spectrum.length)));
}

TEST(OrthospectrumLimits, AStopThatCameBeforeLeavesNothing) {
  const Embedded tripus = testing::embedded_tripus();
  const std::atomic<bool> stop = true;
  SpectrumOptions options;
  options.length = 5;
  Context context;
  context.stop = &stop;
  const Spectrum spectrum = find(tripus, options, context);
  EXPECT_EQ(spectrum.end, SpectrumEnd::kInterrupted);
  EXPECT_EQ(spectrum.length, 0);
  EXPECT_EQ(spectrum.arc_count, 0u);
}

TEST(OrthospectrumLimits, ACountGivesTheShortestWithAllOfTheLastLength) {
  const Embedded tripus = testing::embedded_tripus();
  const auto all =
      testing::lengths_of(testing::spectrum_of(tripus.triangulation, tripus.report, 6.5));
  for (const std::size_t count : {1, 2, 5, 6, 100, 700}) {
    SpectrumOptions options;
    options.count = count;
    const Spectrum spectrum = find(tripus, options);
    ASSERT_GE(spectrum.arcs.size(), count);
    EXPECT_EQ(spectrum.arc_count, spectrum.arcs.size());
    EXPECT_EQ(spectrum.sums.oriented_count(), 2 * spectrum.arc_count);
    const std::size_t found = spectrum.arcs.size();
    for (std::size_t n = 0; n < found; ++n) ASSERT_NEAR(spectrum.arcs[n].length, all[n], 1e-12);
    EXPECT_NEAR(all[found - 1], all[count - 1], 1e-9);
    EXPECT_GT(all[found], all[found - 1] + 1e-9);
  }
}

TEST(OrthospectrumLimits, SumsAloneAreThoseOfTheArcs) {
  const Embedded tripus = testing::embedded_tripus();
  SpectrumOptions options;
  options.length = 7;
  options.keep_arcs = false;
  const Spectrum sums = find(tripus, options);
  options.keep_arcs = true;
  const Spectrum arcs = find(tripus, options);
  EXPECT_TRUE(sums.arcs.empty());
  EXPECT_EQ(sums.arc_count, arcs.arcs.size());
  EXPECT_EQ(sums.sums.area(), arcs.sums.area());
}

/// Edges of one length and the like: long, short, nearly flat tetrahedra.
TEST(OrthospectrumLimits, ExtremeTetrahedraGiveFiniteNumbers) {
  std::size_t tried = 0;
  testing::for_geometric_triangulations(
      150, [&](const std::string& name, const Embedded& manifold, bool) {
        ++tried;
        const Spectrum spectrum = testing::spectrum_of(manifold.triangulation, manifold.report, 4);
        for (const Arc& arc : spectrum.arcs) {
          ASSERT_TRUE(std::isfinite(arc.length) && arc.length > 0) << name;
          for (const ArcEnd& end : {arc.start, arc.end})
            ASSERT_LT(end.x * end.x + end.y * end.y, 1) << name;
        }
        EXPECT_EQ(spectrum.arcs.size(), spectrum.arc_count) << name;
      });
  EXPECT_GT(tried, 50u);
}

}  // namespace
}  // namespace tripus::orthospectrum
