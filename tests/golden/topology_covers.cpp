#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

std::string as_text(const CoverHomology& covers) {
  std::string text;
  for (const auto& [homology, count] : covers)
    text += (text.empty() ? "" : "; ") + homology + " x " + std::to_string(count);
  return text.empty() ? "-" : text;
}

// Law C4 against Regina's own low-index search (data/covers-golden.tsv).
TEST(CoversGolden, AgreeWithRegina) {
  const auto rows = testing::data_table("covers-golden.tsv");
  ASSERT_GT(rows.size(), 100u);
  for (const testing::Row& row : rows) {
    const Triangulation triangulation(decode_isosig(row.at("isosig")));
    const auto degree = static_cast<std::size_t>(std::stoi(row.at("degree")));
    EXPECT_EQ(as_text(cover_homology(triangulation, degree)), row.at("homology"))
        << row.at("isosig") << ", degree " << degree;
  }
}

}  // namespace
}  // namespace tripus::topology
