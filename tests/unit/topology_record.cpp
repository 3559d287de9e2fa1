// The record of a simplification, and what is carried back along it.
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/cube_meshes.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cone.hpp"
#include "topology/covers/covers.hpp"
#include "topology/homology.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/carry_back.hpp"
#include "topology/simplify/simplify_recording.hpp"
#include "topology/subdivide.hpp"

namespace tripus::topology {
namespace {

constexpr double kEffort = 0.05;  // of the search: some hundreds of trials

/// Permutations of sheets; a product is made from left to right.
class Permutations final : public NumberedGroup {
 public:
  using Images = std::vector<std::uint32_t>;
  /// `is_restless`: frames are changed again and again, which must not matter.
  explicit Permutations(std::size_t degree, bool is_restless = false) : is_restless_(is_restless) {
    Images identity(degree);
    std::iota(identity.begin(), identity.end(), 0u);
    number(identity);
  }
  std::uint32_t number(const Images& images) {
    const auto [entry, is_new] = numbers_.try_emplace(images, elements_.size());
    if (is_new) elements_.push_back(images);
    return static_cast<std::uint32_t>(entry->second);
  }
  std::uint32_t product(std::uint32_t first, std::uint32_t second) override {
    Images images;
    for (const std::uint32_t k : elements_[first]) images.push_back(elements_[second][k]);
    return number(images);
  }
  std::uint32_t inverse(std::uint32_t element) override {
    Images images(elements_[element].size());
    for (std::uint32_t k = 0; k < images.size(); ++k) images[elements_[element][k]] = k;
    return number(images);
  }
  double size(std::uint32_t element) const override {
    return element == 0 ? 0 : is_restless_ ? 100 : 1;
  }
  std::vector<std::uint32_t> better_frames(std::span<const Link> links,
                                           std::size_t frames) override {
    EXPECT_TRUE(is_restless_);
    std::vector<std::uint32_t> change(frames, 0);
    for (const Link& link : links)
      if (link.from % 3 != 0) change[link.from] = link.element;
    ++changes;
    return change;
  }
  std::size_t changes = 0;
  std::uint32_t image(std::uint32_t element, std::uint32_t k) const {
    return elements_[element][k];
  }
  std::size_t degree() const { return elements_[0].size(); }

 private:
  bool is_restless_;
  std::map<Images, std::size_t> numbers_;
  std::vector<Images> elements_;
};

/// Tetrahedron t on sheet k has number k T + t.
Gluings cover_of(const Gluings& base, const std::vector<std::uint32_t>& values,
                 const Permutations& group) {
  const std::size_t count = base.tetrahedron_count();
  Gluings cover(count * group.degree());
  for (std::uint32_t k = 0; k < group.degree(); ++k)
    for (std::size_t t = 0; t < count; ++t)
      for (int f = 0; f < 4; ++f) {
        const std::uint32_t sheet = group.image(values[4 * t + static_cast<std::size_t>(f)], k);
        cover.set_one_side(k * count + t, f,
                           static_cast<TetrahedronIndex>(sheet * count + base.neighbour(t, f)),
                           base.gluing(t, f));
      }
  return cover;
}

/// Fine triangulations of small manifolds with boundary, orientable or not, and of solids.
std::vector<Gluings> fine_tables() {
  std::vector<Gluings> tables;
  unsigned n = 0;
  for (const auto& row : testing::compact_manifolds())
    if (n++ % 12 == 0)
      tables.push_back(
          random_relabelling(barycentric_subdivision(decode_isosig(row.at("isosig"))), n));
  for (const char* signature : {"bkaaid", "cPcbbbiht", "eLPkbcddddjwgb", "cPcbbbdxm"})
    tables.push_back(barycentric_subdivision(decode_isosig(signature)));
  tables.push_back(cone_boundary(testing::cube_mesh(5, [](int x, int y, int z) {
    return (x != 1 || y != 1) && (x != 3 || y != 3) && (x != 0 || y != 0 || z != 0);
  })));
  return tables;
}

/// The way back, followed by the tables alone.
class Follow final : public WayBack {
 public:
  void renumbered(const Gluings& slots, std::span<const TetrahedronIndex> number) override {
    EXPECT_EQ(slots.tetrahedron_count(), number.size());
    runs_ += 1;
    last_ = slots;
  }
  void step(const StepBack& step) override {
    EXPECT_EQ(step.after, last_) << "one step ends where the next begins";
    last_ = step.before;
    for (const TetrahedronIndex t : step.made) {
      EXPECT_TRUE(step.before.is_open(t, 0));
      EXPECT_FALSE(step.after.is_open(t, 0));
    }
    ++steps_;
  }
  Gluings table(std::size_t count) {
    last_.resize(count);
    return last_;
  }
  std::size_t steps() const { return steps_; }
  std::size_t runs() const { return runs_; }

 private:
  Gluings last_;
  std::size_t steps_ = 0, runs_ = 0;
};

TEST(SimplificationRecord, ReplaysForwardToTheResultAndBackToTheStart) {
  std::size_t longest = 0;
  for (const Gluings& start : fine_tables()) {
    SimplificationRecord record;
    const Simplified result = simplify_recording(start, record, {.effort = kEffort});
    ASSERT_EQ(replayed(start, record), result.gluings);
    ASSERT_EQ(result.gluings, simplify(start, {.effort = kEffort}).gluings)
        << "a record changes nothing";
    Follow way;
    replay_backwards(start, record, way);
    ASSERT_EQ(way.table(start.tetrahedron_count()), start);
    EXPECT_EQ(way.steps(), record.size());
    EXPECT_LE(way.runs(), 2u);
    longest = std::max(longest, record.size());
    EXPECT_LE(record.memory_bytes(), 10 * record.size() + 64) << "a few bytes a step";
  }
  EXPECT_GT(longest, 100u);
}

TEST(SimplificationRecord, RefusesAnotherTable) {
  const Gluings start = barycentric_subdivision(decode_isosig("cPcbbbihq"));
  SimplificationRecord record;
  simplify_recording(start, record, {.effort = kEffort});
  EXPECT_THROW(replayed(decode_isosig("cPcbbbihq"), record), InvalidInput);
}

// Permutation representations are carried back: they are flat, and the covers of the fine
// triangulation that they make are those of the small one, as the homology tells.
TEST(CarriedBack, CoversOfTheResultAreCoversOfTheStart) {
  std::size_t covers = 0, changes = 0;
  for (const Gluings& start : fine_tables()) {
    SimplificationRecord record;
    const Simplified result = simplify_recording(start, record, {.effort = kEffort});
    const Triangulation small(result.gluings);
    for (const std::size_t degree : {2u, 3u}) {
      int visited = 0;
      for_each_cover(small, degree, [&](const Cover& cover) {
        Permutations group(degree, covers % 2 == 1);
        FlatConnection connection;
        connection.values.assign(4 * small.tetrahedron_count(), 0);
        const std::size_t count = small.tetrahedron_count();
        for (std::size_t slot = 0; slot < 4 * count; ++slot) {
          Permutations::Images images;
          for (std::size_t k = 0; k < degree; ++k)
            images.push_back(static_cast<std::uint32_t>(
                cover.gluings.neighbour(k * count + slot / 4, static_cast<int>(slot % 4)) / count));
          connection.values[slot] = group.number(images);
        }
        EXPECT_TRUE(curved_edges(result.gluings, connection.values, group).empty());
        const FlatConnection fine = carried_back(start, record, connection, group);
        EXPECT_TRUE(curved_edges(start, fine.values, group).empty());
        const Gluings above = cover_of(start, fine.values, group);
        const Triangulation one(above), two(cover.gluings);
        EXPECT_TRUE(one.is_connected());
        EXPECT_EQ(one.is_orientable(), two.is_orientable());
        EXPECT_EQ(to_string(first_homology(one)), to_string(first_homology(two)));
        changes += group.changes;
        ++covers;
        return ++visited < 4;
      });
    }
  }
  EXPECT_GT(covers, 60u);
  EXPECT_GT(changes, 100u);
}

}  // namespace
}  // namespace tripus::topology
