#include "embedding/holonomy.hpp"

#include "embedding/developing_map.hpp"

namespace tripus::embedding {

Holonomy holonomy(const Embedding& embedding, const topology::Triangulation& triangulation) {
  Holonomy result;
  result.group = topology::fundamental_group(triangulation);
  const topology::Gluings& gluings = triangulation.gluings();
  const std::vector<Matrix4> places = developing_map(embedding, gluings);
  const std::size_t count = result.group.presentation.generator_count;
  result.isometries.resize(count);
  result.moebius.resize(count);
  for (std::size_t slot = 0; slot < result.group.face_letters.size(); ++slot) {
    const topology::Letter letter = result.group.face_letters[slot];
    if (letter <= 0) continue;
    const std::size_t t = slot / 4, f = slot % 4;
    const std::size_t other = gluings.neighbour(t, static_cast<int>(f));
    const std::size_t g = topology::generator_of(letter);
    result.moebius[g] = geometry::to_moebius(places[t] * embedding.face_pairings[t][f] *
                                             geometry::lorentz_inverse(places[other]));
    result.isometries[g] = geometry::to_matrix(result.moebius[g]);
    result.orientable = result.orientable && !result.moebius[g].reverses;
  }
  return result;
}

Matrix4 isometry_of(const Holonomy& holonomy, const topology::Word& word) {
  Matrix4 product = Matrix4::Identity();
  for (const topology::Letter letter : word) {
    const Matrix4& generator = holonomy.isometries[topology::generator_of(letter)];
    product = geometry::reorthogonalised(
        product * (letter > 0 ? generator : geometry::lorentz_inverse(generator)));
  }
  return product;
}

std::vector<double> relator_defects(const Holonomy& holonomy) {
  std::vector<double> defects;
  for (const topology::Word& relator : holonomy.group.presentation.relators) {
    const Matrix4 product = isometry_of(holonomy, relator);
    defects.push_back((product - Matrix4::Identity()).cwiseAbs().maxCoeff());
  }
  return defects;
}

}  // namespace tripus::embedding
