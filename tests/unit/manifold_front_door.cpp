// tripus::Manifold: the same answers as the libraries behind it, computed once.
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stop_token>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tripus/tripus.hpp>

#include "base/output_file.hpp"
#include "embedding/export/mesh_formats.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"

namespace tripus {
namespace {

constexpr double kTripusVolume = 6.451990270835034;  // docs/theory.md (28)

TEST(FrontDoor, SolvesWhenFirstAsked) {
  const Manifold M = load("cPcbbbihq");
  const Metric* metric = M.metric();
  ASSERT_NE(metric, nullptr);
  EXPECT_NEAR(metric->volume(), kTripusVolume, 1e-13);
  ASSERT_EQ(metric->edge_lengths().size(), 1u);
  EXPECT_EQ(metric->dihedral_angles().size(), 2u);
  ASSERT_EQ(metric->boundary().size(), 1u);
  EXPECT_EQ(metric->boundary()[0].genus, 2);
  EXPECT_EQ(M.verdict().outcome, structure::Outcome::kGeometric);
  EXPECT_EQ(topology::to_string(M.homology()), "2 Z");
  EXPECT_EQ(M.signature(), "cPcbbbihq");
  EXPECT_EQ(M.links().size(), 1u);
}

TEST(FrontDoor, CopiesShareWhatWasComputed) {
  static_assert(std::is_copy_constructible_v<Manifold> && std::is_copy_assignable_v<Manifold>);
  const Manifold M = load("cPcbbbihq");
  const Manifold copy = M;
  EXPECT_EQ(M.metric(), copy.metric());
  EXPECT_EQ(&M.verdict(), &copy.verdict());
}

TEST(FrontDoor, AVerdictIsNoMetric) {
  const Manifold M = load("dLQbcbcaekw");
  EXPECT_EQ(M.metric(), nullptr);
  EXPECT_EQ(M.verdict().outcome, structure::Outcome::kInfeasible);
  EXPECT_TRUE(M.verdict().certificate.has_value());
}

TEST(FrontDoor, FindsAnotherTriangulation) {
  const Manifold M = load("eLAkbccdddprdk");
  EXPECT_EQ(M.metric(), nullptr);
  const Manifold N = M.retriangulated();
  ASSERT_NE(N.metric(), nullptr);
  EXPECT_NEAR(N.metric()->volume(), 7.63651962957956, 1e-10);
  ASSERT_NE(M.identify(), nullptr);
  EXPECT_EQ(M.identify()->name, "t3g2.13");
  EXPECT_EQ(M.is_isometric_to(N), true);
}

TEST(FrontDoor, TellsManifoldsApart) {
  const Manifold M = load("cPcbbbihq"), N = load("cPcbbbdhq");
  EXPECT_EQ(M.is_isometric_to(N), false);
  EXPECT_NE(M.isometry_signature(), N.isometry_signature());
  ASSERT_TRUE(M.isometry_group().has_value());
  EXPECT_EQ(M.isometry_group()->order, 6u);
  EXPECT_EQ(M.covers(2).size(), 3u);
}

TEST(FrontDoor, WhatAStopCutShortIsAskedAgain) {
  const Manifold M = load("dLQabccjkjn");  // equal lengths are no solution: it takes iterations
  std::stop_source source;
  source.request_stop();
  Context stopped;
  stopped.stop = source.get_token();
  EXPECT_EQ(M.metric(stopped), nullptr);
  EXPECT_EQ(M.verdict(stopped).outcome, structure::Outcome::kUnresolved);
  EXPECT_NE(M.metric(), nullptr);
  EXPECT_NE(M.metric(stopped), nullptr) << "what is known needs no more work";
}

TEST(FrontDoor, WritesJsonAndCells) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "tripus-front-door";
  std::filesystem::create_directories(folder);
  const Manifold M = load("cPcbbbihq");
  const auto json = nlohmann::json::parse(M.to_json());
  EXPECT_EQ(json.at("input"), "cPcbbbihq");
  EXPECT_EQ(json.at("outcome"), "geometric");
  EXPECT_NEAR(json.at("volume").get<double>(), kTripusVolume, 1e-13);
  M.write((folder / "m.json").string());
  EXPECT_TRUE(std::filesystem::file_size(folder / "m.json") > 100);
  EXPECT_THROW(M.write((folder / "m.txt").string()), InvalidInput);

  const CellComplex cells = M.metric()->universal_cover(20);
  EXPECT_EQ(cells.cells().size(), 20u);
  EXPECT_EQ(M.metric()->fundamental_domain().cells().size(), 2u);
  for (const embedding::CellFormat& format : embedding::mesh_formats()) {
    const std::string path = (folder / ("cells." + std::string(format.extension))).string();
    EXPECT_EQ(cells.write(path), 20u) << path;
    EXPECT_GT(std::filesystem::file_size(path), 1000u) << path;
  }
  EXPECT_THROW(cells.write((folder / "cells.xyz").string()), InvalidInput);
  EXPECT_THROW(cells.write((folder / "none" / "cells.ply").string()), InvalidInput);
  std::filesystem::remove_all(folder);
}

TEST(FrontDoor, RefusesWhatIsNoManifold) {
  EXPECT_THROW(load("no-such-file.off"), InvalidInput);
  EXPECT_THROW(load(""), InvalidInput);
  EXPECT_THROW(Manifold(topology::Gluings{}), InvalidInput);
}

/// A file at its name is the old one or the new one, whole.
TEST(FrontDoor, KeepsWhatItWasMadeFrom) {
  topology::NamedGluings given = load_input("cPcbbbihq-");
  given.name = "mirror";
  const Manifold M(given, "from elsewhere");
  EXPECT_EQ(M.name(), "mirror");
  EXPECT_EQ(M.input(), "from elsewhere");
  EXPECT_EQ(M.label(), "from elsewhere");
  EXPECT_TRUE(M.is_orientation_known());
  EXPECT_EQ(M.oriented_signature(), "cPcbbbihq-");
  EXPECT_FALSE(load("cPcbbbihq").is_orientation_known());
  EXPECT_EQ(load("cPcbbbihq").oriented_signature(), std::nullopt);
  given.cone_angles.assign(2, 1.0);
  EXPECT_THROW(Manifold(given, "too many labels"), InvalidInput);
}

TEST(FrontDoor, KnowsConeAngles) {
  using topology::ConeAngle;
  const ConeAngle half = topology::parse_cone_order("2");
  const Manifold plain = load("cPcbbbiht"), M = load("cPcbbbiht 0=2,1=2");
  EXPECT_TRUE(plain.cone_angles().empty());
  ASSERT_EQ(M.cone_angles().size(), 2u);
  EXPECT_EQ(M.cone_angles()[0], half);
  EXPECT_EQ(M.label(), "cPcbbbiht 0=2,1=2");
  const Manifold same = plain.with_cone_angles({half, half});
  EXPECT_EQ(same.label(), M.label());
  EXPECT_EQ(same.with_cone_angles({}).label(), "cPcbbbiht");
  EXPECT_EQ(Manifold(M.triangulation()).with_cone_angles({half, half}).label(), M.label());
  for (const Manifold& labelled : {M, same}) {
    ASSERT_NE(labelled.metric(), nullptr);
    EXPECT_NEAR(labelled.metric()->volume(), kTripusVolume, 1e-12);
    EXPECT_EQ(labelled.metric()->embedding().singular_edges, (std::vector<std::uint8_t>{63, 63}));
    EXPECT_TRUE(labelled.metric()->prove().proved);
    EXPECT_TRUE(nlohmann::json::parse(labelled.to_json()).contains("cone_orders"));
  }
  // Labels of the call are on top of those of the manifold.
  structure::SolveOptions without;
  without.cone_angles.resize(2);
  EXPECT_NEAR(M.solve(without).volume, plain.metric()->volume(), 1e-12);
  EXPECT_EQ(M.compare(same).verdict, canonical::Verdict::kHomeomorphic);
  EXPECT_EQ(M.compare(plain.with_cone_angles({half, topology::parse_cone_order("3")})).verdict,
            canonical::Verdict::kDifferent);
  EXPECT_NE(M.isometry_signature(), plain.isometry_signature());
  // A cover has the labels of what lies below, and so a multiple of the volume.
  for (const Manifold& cover : plain.with_cone_angles({half, ConeAngle()}).covers(3)) {
    EXPECT_EQ(std::ranges::count(cover.cone_angles(), half), 3);
    EXPECT_EQ(cover.cone_angles().size(), 6u);
  }
  EXPECT_THROW(M.simplified(), Unsupported);
  EXPECT_THROW(M.with_cone_angles({half}), InvalidInput);
}

TEST(FrontDoor, MakesTheCoverOfPermutations) {
  const Manifold M = load("cPcbbbihq");
  const std::size_t generators = M.fundamental_group().presentation.generator_count;
  const std::vector<std::uint32_t> swap{1, 0}, stay{0, 1};
  std::size_t covers = 0;
  for (unsigned choice = 0; choice < 1u << generators; ++choice) {
    std::vector<std::vector<std::uint32_t>> images;
    for (std::size_t g = 0; g < generators; ++g)
      images.push_back((choice >> g & 1u) != 0 ? swap : stay);
    try {
      EXPECT_EQ(M.cover(images).tetrahedron_count(), 4u);
      ++covers;
    } catch (const InvalidInput&) {
    }
  }
  EXPECT_EQ(covers, M.covers(2).size());
  EXPECT_THROW(M.cover({}), InvalidInput);
  const auto each = [&](std::vector<std::uint32_t> images) {
    return std::vector<std::vector<std::uint32_t>>(generators, std::move(images));
  };
  EXPECT_THROW(M.cover(each({0, 0})), InvalidInput);
  EXPECT_THROW(M.cover(each({})), InvalidInput);
  const std::atomic<bool> stop{true};
  Context stopped;
  stopped.stop = &stop;
  EXPECT_THROW(M.cover(each({1, 0}), stopped), Error);
}

TEST(OutputFile, IsWholeOrNotThere) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "tripus-output-file";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "file.txt").string();
  const auto content = [&] {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto files = [&] { return std::distance(std::filesystem::directory_iterator(folder), {}); };
  { const OutputFile only_tried(path); }
  EXPECT_EQ(files(), 0) << "a trial leaves nothing behind";
  write_file(path, "old");
  EXPECT_EQ(content(), "old");
  {
    OutputFile file(path);
    file.open() << "half of the new";
    EXPECT_EQ(content(), "old");
  }
  EXPECT_EQ(content(), "old") << "what was not closed is not there";
  EXPECT_EQ(files(), 1);
  std::filesystem::create_symlink(path, folder / "link");
  write_file((folder / "link").string(), "new");
  EXPECT_EQ(content(), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));

  namespace fs = std::filesystem;
  fs::permissions(path, fs::perms::owner_read);
  EXPECT_THROW(write_file(path, "never"), InvalidInput);
  EXPECT_EQ(content(), "new");
  EXPECT_THROW(write_file(folder.string(), "never"), InvalidInput);
  EXPECT_THROW(write_file((folder / "none" / "x").string(), "never"), InvalidInput);
  EXPECT_THROW(write_file("/dev/full", "never"), IoError);
  fs::permissions(path, fs::perms::owner_all);
  fs::remove_all(folder);
}

TEST(FrontDoor, DrillsEdgesOut) {
  // The knot 4_1 as an edge of the sphere, with a cone order that is taken away first.
  const auto loaded = topology::small_exterior(
      topology::read_diagram("PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8] Cone[1,4]"));
  std::size_t knot = 0;
  while (loaded.cone_angles[knot].is_full()) ++knot;
  const Manifold sphere(loaded.gluings);
  EXPECT_EQ(sphere.drilled({knot}).signature(), "cPcbbbiht");
  EXPECT_THROW(sphere.drilled({sphere.triangulation().edge_count()}), InvalidInput);
  EXPECT_THROW(sphere.drilled({knot, knot}), InvalidInput);
  // Cone angles: all that are there must be drilled, as none is kept.
  const auto labelled = load("cPcbbbiht 0=2,1=3");
  EXPECT_THROW(labelled.drilled({0}), InvalidInput);
  EXPECT_EQ(labelled.drilled({0, 1}).triangulation().vertex_count(), 1u);
}

}  // namespace
}  // namespace tripus
