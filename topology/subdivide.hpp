#pragma once

#include "topology/gluings.hpp"

namespace tripus::topology {

/// The barycentric subdivision: tetrahedron 24 t + p.rank() lies in tetrahedron t, and its corners
/// are vertex p(0), the middle of the edge to p(1), the middle of the face with p(2), and the
/// middle of t; the last two are swapped where p is odd, so that oriented tables stay oriented.
/// Open faces become six open faces each. O(T). An edge that is identified with its own reverse
/// becomes harmless: its middle is a vertex, with the projective plane as its link. Throws
/// InvalidInput, naming tetrahedron and face, if the gluings are not consistent or the result would
/// have more than kMaxTetrahedra tetrahedra.
Gluings barycentric_subdivision(const Gluings& gluings);

}  // namespace tripus::topology
