// Deck transformations far from the identity, or by way of what is far: law E3 of
// embedding/README.md.
#include <algorithm>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "embedding/developing_map.hpp"
#include "embedding/holonomy.hpp"
#include "embedding/universal_cover.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "topology/covers/covers.hpp"

namespace tripus::embedding {
namespace {

constexpr double kBound = 1e-9;
constexpr std::size_t kDepth = 30;

/// Largest entry of M^T J M - J, exactly, each against the lengths of its two columns where these
/// are longer than 1: doubles cannot hold it better than to rounding of that.
double gram_defect(const Matrix4& matrix) {
  using Wide = boost::multiprecision::cpp_bin_float_100;
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      Wide product = i != j ? 0 : i == 3 ? 1 : -1;
      for (int k = 0; k < 4; ++k)
        product += (k == 3 ? -1 : 1) * Wide(matrix(k, i)) * Wide(matrix(k, j));
      const double size = std::max(1.0, matrix.col(i).norm() * matrix.col(j).norm());
      largest = std::max(largest, std::abs(static_cast<double>(product)) / size);
    }
  }
  return largest;
}

/// The same; 0 for one that carries farther than doubles reach, and is printed as null.
double finite_gram_defect(const Matrix4& matrix) {
  return matrix.allFinite() ? gram_defect(matrix) : 0;
}

Matrix4 inverse_of(const Matrix4& isometry) {
  const Matrix4 j = Vector4(1, 1, 1, -1).asDiagonal();
  return j * isometry.transpose() * j;
}

/// What multiplying the matrices of the generators gives: the baseline.
Matrix4 product_in_doubles(const Holonomy& holonomy, const topology::Word& word) {
  Matrix4 product = Matrix4::Identity();
  for (const topology::Letter letter : word) {
    const Matrix4& matrix = holonomy.isometries[topology::generator_of(letter)];
    product = product * (letter > 0 ? matrix : inverse_of(matrix));
  }
  return product;
}

class Words {
 public:
  explicit Words(std::size_t generators) : generators_(static_cast<int>(generators)) {}
  topology::Word random(std::size_t length) {
    std::uniform_int_distribution<topology::Letter> letter(1, generators_);
    topology::Word word(length);
    for (topology::Letter& x : word) x = letter(random_) * (random_() % 2 == 0 ? 1 : -1);
    return word;
  }
  /// Out and back by another way where `detour` is not empty.
  topology::Word round_trip(const topology::Word& out, const topology::Word& detour) const {
    topology::Word word = out;
    word.insert(word.end(), detour.begin(), detour.end());
    for (std::size_t n = out.size(); n-- > 0;) word.push_back(-out[n]);
    return word;
  }

 private:
  int generators_;
  std::mt19937 random_{20261130};
};

const char* const kManifolds[] = {"cPcbbbihq", "dLQbcccdhkw", "dLQbccchrqg", "eLPkbcdddjjvkx"};

TEST(DeckTransformations, AreLorentzMatricesAtDepthThirty) {
  double baseline = 0;
  for (const char* name : kManifolds) {
    SCOPED_TRACE(name);
    const auto m = testing::try_embed(name).value();
    const Holonomy h = holonomy(m.embedding, m.triangulation);
    Words words(h.isometries.size());
    for (int n = 0; n < 50; ++n) {
      const topology::Word half = words.random(kDepth / 2);
      for (const topology::Word& word :
           {words.random(kDepth), words.round_trip(half, {}),
            words.round_trip(words.random(kDepth / 2 - 1), words.random(2))}) {
        ASSERT_EQ(word.size(), kDepth);
        EXPECT_LT(gram_defect(isometry_of(h, word)), kBound);
        baseline = std::max(baseline, gram_defect(product_in_doubles(h, word)));
      }
      EXPECT_LT((isometry_of(h, words.round_trip(half, {})) - Matrix4::Identity()).norm(), kBound);
    }
  }
  EXPECT_GT(baseline, 1.0);  // there is something to be cured
}

TEST(DeckTransformations, AreTheSameAsMoebiusMaps) {
  for (const char* name : kManifolds) {
    SCOPED_TRACE(name);
    const auto m = testing::try_embed(name).value();
    const Holonomy h = holonomy(m.embedding, m.triangulation);
    Words words(h.isometries.size());
    for (int n = 0; n < 50; ++n) {
      const topology::Word word = words.random(std::size_t(n) % 8);
      const geometry::MoebiusMap map = moebius_of(h, word);
      const Matrix4 matrix = isometry_of(h, word);
      EXPECT_LT((geometry::to_matrix(map) - matrix).norm(), 1e-13 * matrix.norm());
      EXPECT_LT((product_in_doubles(h, word) - matrix).norm(), 1e-7 * matrix.norm());
    }
  }
}

/// Every generator, of domains so large that double precision does not hold the relators.
TEST(DeckTransformations, OfLargeDomainsAreLorentzMatrices) {
  const auto base = testing::embedded_tripus();
  for (const std::size_t degree : {5, 40, 200}) {
    topology::Gluings gluings;
    topology::for_each_cyclic_cover(base.triangulation, degree, [&](const topology::Cover& cover) {
      gluings = cover.gluings;
      return false;
    });
    const topology::Triangulation cover(gluings);
    const std::vector<double> lengths(cover.edge_count(), base.report.edge_lengths[0]);
    const Embedding embedded = embed(cover, lengths);
    const Holonomy h = holonomy(embedded, cover);
    std::vector<Matrix4> matrices = h.isometries;
    for (const Cell& cell : fundamental_domain(embedded, gluings))
      matrices.push_back(cell.isometry);
    for (const Matrix4& matrix : matrices) EXPECT_LT(finite_gram_defect(matrix), kBound) << degree;
  }
}

TEST(DeckTransformations, OfCellsAreLorentzMatrices) {
  const auto m = testing::embedded_tripus();
  UniversalCoverOptions options;
  options.max_cells = 20000;
  for (const Cell& cell : universal_cover(m.embedding, m.triangulation, options))
    EXPECT_LT(gram_defect(cell.isometry), kBound);
}

}  // namespace
}  // namespace tripus::embedding
