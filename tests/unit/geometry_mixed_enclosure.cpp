// The enclosures of tetrahedra with ideal vertices in doubles, against Arb at 200 bits.
#include <cfenv>
#include <cstdio>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "geometry/enclosure.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"

namespace tripus::geometry {
namespace {

using structure::detail::Arb;
using structure::detail::Diagonal;
using structure::detail::Precision;

/// One block of tetrahedra of one kind.
struct Block {
  Diagonal diagonal;
  std::vector<double> lengths, radii;  // [6][8]

  Block(const Diagonal& kinds, double size, double radius, std::mt19937_64& random)
      : diagonal(kinds), lengths(6 * kLanes), radii(6 * kLanes) {
    std::uniform_real_distribution<double> sign(-1, 1);
    for (std::size_t e = 0; e < 6; ++e) {
      const EdgeFrame& frame = kEdgeFrames[e];
      const bool planes = kinds[static_cast<std::size_t>(frame.i)] == 1 &&
                          kinds[static_cast<std::size_t>(frame.j)] == 1;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const double x = sign(random);
        lengths[e * kLanes + lane] = size * (planes ? 1.01 + x : x);
        radii[e * kLanes + lane] = radius * (1 + sign(random));
      }
    }
  }

  /// A tetrahedron of the box: where = 0 is its middle.
  std::array<Arb, 6> tetrahedron(std::size_t lane, const std::array<double, 6>& where) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e)
      l[e] = Arb(lengths[e * kLanes + lane]) + Arb(where[e]) * Arb(radii[e * kLanes + lane]);
    return l;
  }
};

void expect_inside(const Arb& x, double mid, double low, double radius) {
  EXPECT_FALSE((Arb(mid) + Arb(low) - x).magnitude().lower() > radius)
      << mid << " +- " << radius << " against " << x.mid();
}

std::vector<Block> random_blocks() {
  std::mt19937_64 random(20261130);
  std::vector<Block> blocks;
  for (int kinds = 0; kinds < 16; ++kinds) {
    Diagonal diagonal;
    for (std::size_t v = 0; v < 4; ++v) diagonal[v] = kinds >> v & 1;
    for (const double size : {1e-3, 0.3, 1.0, 3.0, 9.0, 39.0})
      for (const double radius : {0.0, 1e-14, 1e-8, 1e-3})
        blocks.emplace_back(diagonal, size, radius, random);
  }
  return blocks;
}

TEST(MixedEnclosures, ContainTheTruth) {
  const Precision precision(200);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> sign(-1, 1);
  std::vector<double> out(kMixedEnclosed * kLanes);
  const auto at = [&](std::size_t q, std::size_t lane) { return out[q * kLanes + lane]; };
  std::size_t sound = 0, sound_over_box = 0;
  for (const Block& block : random_blocks()) {
    const GramDiagonal diagonal = structure::detail::gram_diagonal(block.diagonal);
    enclosure_kernels().mixed_angles(1, block.lengths.data(), diagonal, out.data(), true);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (at(kSound, lane) == 0) continue;
      ++sound;
      const auto truth =
          structure::detail::precise_tetrahedron(block.tetrahedron(lane, {}), true, block.diagonal);
      ASSERT_TRUE(truth);
      for (std::size_t e = 0; e < 6; ++e)
        expect_inside(truth->angles[e], at(kAngleMid + e, lane), at(kAngleLow + e, lane),
                      at(kAngleRadius + e, lane));
      expect_inside(truth->volume, at(kVolumeMid, lane), 0, at(kVolumeRadius, lane));
    }
    enclosure_kernels().mixed_jacobian(1, block.lengths.data(), block.radii.data(), diagonal,
                                       out.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (at(kSound, lane) == 0) continue;
      ++sound_over_box;
      for (int member = 0; member < 4; ++member) {
        std::array<double, 6> where{};
        for (double& x : where)
          x = member == 0 ? 0 : member == 1 ? std::copysign(1, sign(random)) : sign(random);
        const auto truth =
            structure::detail::precise_jacobian(block.tetrahedron(lane, where), block.diagonal);
        ASSERT_TRUE(truth);
        for (std::size_t k = 0; k < truth->size(); ++k)
          expect_inside((*truth)[k], at(kJacobianMid + k, lane), 0, at(kJacobianRadius + k, lane));
      }
    }
  }
  std::printf("%zu tetrahedra, %zu boxes\n", sound, sound_over_box);
  EXPECT_GT(sound, 1500u);
  EXPECT_GT(sound_over_box, 1000u);
}

TEST(MixedEnclosures, AreTheSameBitsWithAllInstructions) {
  std::vector<double> out(kMixedEnclosed * kLanes), other(out.size());
  for (const EnclosureKernels& kernels : all_enclosure_kernels())
    for (const Block& block : random_blocks()) {
      const GramDiagonal diagonal = structure::detail::gram_diagonal(block.diagonal);
      const EnclosureKernels& first = all_enclosure_kernels().front();
      const auto expect_same = [&] {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          ASSERT_EQ(out[kSound * kLanes + lane], other[kSound * kLanes + lane]) << kernels.name;
          for (std::size_t q = 0; out[kSound * kLanes + lane] > 0 && q < kMixedEnclosed; ++q)
            ASSERT_EQ(out[q * kLanes + lane], other[q * kLanes + lane]) << kernels.name << " " << q;
        }
      };
      first.mixed_angles(1, block.lengths.data(), diagonal, out.data(), true);
      kernels.mixed_angles(1, block.lengths.data(), diagonal, other.data(), true);
      expect_same();
      std::ranges::fill(out, 0);
      std::ranges::fill(other, 0);
      first.mixed_jacobian(1, block.lengths.data(), block.radii.data(), diagonal, out.data());
      kernels.mixed_jacobian(1, block.lengths.data(), block.radii.data(), diagonal, other.data());
      expect_same();
      std::ranges::fill(out, 0);
      std::ranges::fill(other, 0);
    }
}

// Lengths that no kernel takes, and a thread that does not round to nearest.
TEST(MixedEnclosures, OfLengthsOutOfRangeAreNotSound) {
  std::vector<double> out(kMixedEnclosed * kLanes);
  const std::vector<double> radii(6 * kLanes, 0.0);
  const auto sound = [&](const std::vector<double>& lengths, const GramDiagonal& diagonal) {
    for (const EnclosureKernels& kernels : all_enclosure_kernels()) {
      kernels.mixed_angles(1, lengths.data(), diagonal, out.data(), true);
      if (out[kSound * kLanes] > 0) return true;
      kernels.mixed_jacobian(1, lengths.data(), radii.data(), diagonal, out.data());
      if (out[kSound * kLanes] > 0) return true;
    }
    return false;
  };
  const GramDiagonal ideal{{0, 0, 0, 0}}, one{{0, 1, 1, 1}};
  std::vector<double> lengths(6 * kLanes, 0.5);
  EXPECT_TRUE(sound(lengths, ideal));
  EXPECT_TRUE(sound(lengths, one));
  for (const double bad : {41.0, -41.0, 1e300, -1e300, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    lengths[0] = bad;
    EXPECT_FALSE(sound(lengths, ideal)) << bad;
  }
  lengths[0] = 0.5;
  for (const double bad : {0.0, -0.5, -0.0}) {
    lengths[5 * kLanes] = bad;  // between two hyperideal vertices
    EXPECT_FALSE(sound(lengths, one)) << bad;
  }
  lengths[5 * kLanes] = 0.5;
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const bool found = sound(lengths, ideal);
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(found) << mode;
  }
}

}  // namespace
}  // namespace tripus::geometry
