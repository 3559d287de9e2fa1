// The enclosing kernels. CMake compiles this file once for each instruction set, as
// batch_kernel.cpp.
#include <algorithm>
#include <cfloat>
#include <cstring>

#include "geometry/detail/double_ball.hpp"
#include "geometry/detail/enclosure_weights.hpp"
#include "geometry/enclosure.hpp"

static_assert(FLT_EVAL_METHOD == 0, "the radii account for double precision alone");
#ifdef __FAST_MATH__
#error "enclosures need IEEE arithmetic"
#endif

namespace tripus::geometry {
namespace {

constexpr int kEnclosureWidth = TRIPUS_PACK_WIDTH;
using EnclosureLanes = Pack<kEnclosureWidth>;
using B = Ball<EnclosureLanes>;

inline EnclosureLanes load_lanes(const double* from) {
  EnclosureLanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store_lanes(double* to, EnclosureLanes x) { std::memcpy(to, &x, sizeof x); }

/// The volume needs less: from here on in balls of one double.
B volume_in_balls(const GramEnclosure<DoubleBall<EnclosureLanes>>& precise,
                  const DoubleBall<EnclosureLanes>& root,
                  const DoubleBall<EnclosureLanes> (&precise_theta)[6]) {
  GramEnclosure<B> gram;
  B theta[6];
  for (int e = 0; e < 6; ++e) {
    gram.s[e] = to_ball(precise.s[e]);
    gram.cofactor[e] = to_ball(precise.cofactor[e]);
    theta[e] = to_ball(precise_theta[e]);
  }
  for (int v = 0; v < 4; ++v) gram.minor[v] = to_ball(precise.minor[v]);
  gram.minus_det = to_ball(precise.minus_det);
  return volume_enclosure(gram, to_ball(root), theta);
}

/// Whether the angles are known at all.
auto store_angles(double* out, const DoubleBall<EnclosureLanes> (&theta)[6]) {
  const EnclosureLanes limit = broadcast<EnclosureLanes>(kEnclosureLimit);
  auto sound = limit == limit;
  for (std::size_t e = 0; e < 6; ++e) {
    store_lanes(out + kLanes * (kAngleMid + e), theta[e].hi);
    store_lanes(out + kLanes * (kAngleLow + e), theta[e].lo);
    store_lanes(out + kLanes * (kAngleRadius + e), theta[e].r);
    sound &= theta[e].r < limit;
  }
  return sound;
}

void enclose_pack(const double* lengths, const double* radii, double* out, bool with_volume) {
  using Lanes = EnclosureLanes;
  const Lanes zero = broadcast<Lanes>(0.0), limit = broadcast<Lanes>(kEnclosureLimit);
  DoubleBall<Lanes> cosh[6], sinh[6];
  B wide_cosh[6], wide_sinh[6];
  auto sound = zero == zero;
  for (std::size_t e = 0; e < 6; ++e) {
    const Lanes l = load_lanes(lengths + kLanes * e), r = load_lanes(radii + kLanes * e);
    sound &= (l > r) & (l <= limit) & (r >= zero);
    const auto at = double_sinh_cosh<Lanes>(minimum(maximum(l, zero), limit));
    sinh[e] = at.sinh;
    cosh[e] = at.cosh;
    const auto over = widened<Lanes>({to_ball(at.sinh), to_ball(at.cosh)}, r);
    wide_sinh[e] = over.sinh;
    wide_cosh[e] = over.cosh;
  }
  {
    const auto gram = gram_enclosure(cosh, sinh);
    sound &= lower(to_ball(gram.minus_det)) > zero;
    const auto root = square_root(gram.minus_det);
    DoubleBall<Lanes> theta[6];
    angle_enclosures(gram, root, theta);
    sound &= store_angles(out, theta);
    const B volume = with_volume ? volume_in_balls(gram, root, theta) : constant<Lanes>(0, 0);
    store_lanes(out + kLanes * kVolumeMid, volume.m);
    store_lanes(out + kLanes * kVolumeRadius, volume.r);
  }
  const auto gram = gram_enclosure(wide_cosh, wide_sinh);
  sound &= lower(gram.minus_det) > zero;
  B jacobian[kPackedJacobian];
  jacobian_enclosure(gram, square_root(gram.minus_det), jacobian);
  Lanes weight[6];
  const Lanes pivot = corner_weights(jacobian, weight);
  sound &= pivot > zero;
  for (std::size_t e = 0; e < 6; ++e)
    store_lanes(out + kLanes * (kWeight + e), sound ? weight[e] : zero);
}

void enclose(std::size_t blocks, const double* lengths, const double* radii, double* out,
             bool with_volume) {
  if (!rounds_to_nearest()) {
    std::fill(out, out + kEnclosed * kLanes * blocks, 0.0);
    return;
  }
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t lane = 0; lane < kLanes; lane += kEnclosureWidth)
      enclose_pack(lengths + 6 * kLanes * b + lane, radii + 6 * kLanes * b + lane,
                   out + kEnclosed * kLanes * b + lane, with_volume);
}

// ---- ideal vertices -----------------------------------------------------------------------------

/// -G_ij and its slope at the edges of a pack of tetrahedra, theory (77).
template <class N>
struct MixedEntries {
  N c[6], s[6];
};

/// e^l at the point l, |l| <= kEnclosureLimit.
inline DoubleBall<EnclosureLanes> double_exponential(EnclosureLanes l) {
  const EnclosureLanes zero = broadcast<EnclosureLanes>(0.0);
  const auto at = double_sinh_cosh<EnclosureLanes>(
      minimum(magnitude(l), broadcast<EnclosureLanes>(kEnclosureLimit)));
  const auto e = at.sinh + at.cosh;
  return select(l < zero, number_like(1.0, e) / e, e);
}

/// Whether the ends of edge e are both hyperideal; both ideal.
inline bool between_planes(const GramDiagonal& d, int e) {
  return d[kEdgeFrames[e].i] * d[kEdgeFrames[e].j] != 0;
}
inline bool between_ideals(const GramDiagonal& d, int e) {
  return d[kEdgeFrames[e].i] + d[kEdgeFrames[e].j] == 0;
}

MixedEntries<DoubleBall<EnclosureLanes>> entries_at(const double* lengths, const GramDiagonal& d) {
  MixedEntries<DoubleBall<EnclosureLanes>> entries;
  for (int e = 0; e < 6; ++e) {
    const EnclosureLanes l = load_lanes(lengths + kLanes * static_cast<std::size_t>(e));
    if (between_planes(d, e)) {
      const auto at = double_sinh_cosh<EnclosureLanes>(minimum(
          maximum(l, broadcast<EnclosureLanes>(0.0)), broadcast<EnclosureLanes>(kEnclosureLimit)));
      entries.c[e] = at.cosh;
      entries.s[e] = at.sinh;
    } else {
      const auto exponential = double_exponential(l);
      entries.c[e] = entries.s[e] = between_ideals(d, e) ? 2.0 * exponential : exponential;
    }
  }
  return entries;
}

/// The same over a box: |e^(l + d) - e^l| <= e^l |d| e^|d|, as `widened` has it for cosh.
MixedEntries<B> entries_over(const MixedEntries<DoubleBall<EnclosureLanes>>& at,
                             const double* radii) {
  MixedEntries<B> over;
  for (int e = 0; e < 6; ++e) {
    const EnclosureLanes r = load_lanes(radii + kLanes * static_cast<std::size_t>(e));
    const auto wide = widened<EnclosureLanes>({to_ball(at.s[e]), to_ball(at.c[e])}, r);
    over.c[e] = wide.cosh;
    over.s[e] = wide.sinh;
  }
  return over;
}

/// Lanes whose lengths are in range: positive between hyperideal vertices, all over the box.
auto in_range(const double* lengths, const double* radii, const GramDiagonal& d) {
  const EnclosureLanes zero = broadcast<EnclosureLanes>(0.0);
  const EnclosureLanes limit = broadcast<EnclosureLanes>(kEnclosureLimit);
  auto sound = zero == zero;
  for (int e = 0; e < 6; ++e) {
    const std::size_t at = kLanes * static_cast<std::size_t>(e);
    const EnclosureLanes l = load_lanes(lengths + at);
    const EnclosureLanes r = radii == nullptr ? zero : load_lanes(radii + at);
    sound &= (magnitude(l) <= limit) & (r >= zero);
    if (between_planes(d, e)) sound &= l > r;
  }
  return sound;
}

inline bool is_ideal(const GramDiagonal& d) { return d[0] + d[1] + d[2] + d[3] == 0; }

/// Milnor's formula: theory (24) is ill-conditioned there.
B ideal_volume(const DoubleBall<EnclosureLanes> (&theta)[6]) {
  B sum = clausen(to_ball(2.0 * theta[0]));
  for (int e = 1; e < 3; ++e) sum = sum + clausen(to_ball(2.0 * theta[e]));
  return 0.5 * sum;
}

void mixed_angles_pack(const double* lengths, const GramDiagonal& d, double* out,
                       bool with_volume) {
  using Lanes = EnclosureLanes;
  const Lanes zero = broadcast<Lanes>(0.0), one = broadcast<Lanes>(1.0);
  const Lanes limit = broadcast<Lanes>(kEnclosureLimit);
  auto sound = in_range(lengths, nullptr, d);
  const auto entries = entries_at(lengths, d);
  const auto gram = gram_enclosure(entries.c, entries.s, d);
  sound &= lower(to_ball(gram.minus_det)) > zero;
  const auto root = square_root(gram.minus_det);
  DoubleBall<Lanes> theta[6];
  angle_enclosures(gram, root, theta);
  sound &= store_angles(out, theta);
  B volume = constant<Lanes>(0, 0);
  if (with_volume) volume = is_ideal(d) ? ideal_volume(theta) : volume_in_balls(gram, root, theta);
  sound &= volume.r < limit;
  store_lanes(out + kLanes * kVolumeMid, volume.m);
  store_lanes(out + kLanes * kVolumeRadius, volume.r);
  store_lanes(out + kLanes * kSound, sound ? one : zero);
}

void mixed_jacobian_pack(const double* lengths, const double* radii, const GramDiagonal& d,
                         double* out) {
  using Lanes = EnclosureLanes;
  const Lanes zero = broadcast<Lanes>(0.0), one = broadcast<Lanes>(1.0);
  auto sound = in_range(lengths, radii, d);
  const auto entries = entries_over(entries_at(lengths, d), radii);
  const auto gram = gram_enclosure(entries.c, entries.s, d);
  sound &= lower(gram.minus_det) > zero;
  B jacobian[kPackedJacobian];
  jacobian_enclosure(gram, square_root(gram.minus_det), jacobian, d);
  for (std::size_t k = 0; k < kPackedJacobian; ++k) {
    store_lanes(out + kLanes * (kJacobianMid + k), jacobian[k].m);
    store_lanes(out + kLanes * (kJacobianRadius + k), jacobian[k].r);
    sound &= jacobian[k].r < broadcast<Lanes>(kInfinite);
  }
  store_lanes(out + kLanes * kSound, sound ? one : zero);
}

/// `enclose_pack(first place of lengths, first place of results)` for every pack of the blocks.
template <class EnclosePack>
void for_each_pack(std::size_t blocks, double* out, EnclosePack enclose_pack) {
  if (!rounds_to_nearest()) {
    std::fill(out, out + kMixedEnclosed * kLanes * blocks, 0.0);
    return;
  }
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t lane = 0; lane < kLanes; lane += kEnclosureWidth)
      enclose_pack(6 * kLanes * b + lane, out + kMixedEnclosed * kLanes * b + lane);
}

void mixed_angles(std::size_t blocks, const double* lengths, const GramDiagonal& diagonal,
                  double* out, bool with_volume) {
  for_each_pack(blocks, out, [&](std::size_t at, double* to) {
    mixed_angles_pack(lengths + at, diagonal, to, with_volume);
  });
}

void mixed_jacobian(std::size_t blocks, const double* lengths, const double* radii,
                    const GramDiagonal& diagonal, double* out) {
  for_each_pack(blocks, out, [&](std::size_t at, double* to) {
    mixed_jacobian_pack(lengths + at, radii + at, diagonal, to);
  });
}

}  // namespace

extern const EnclosureKernels TRIPUS_ENCLOSURES;
const EnclosureKernels TRIPUS_ENCLOSURES{TRIPUS_KERNELS_NAME, enclose, mixed_angles,
                                         mixed_jacobian};

}  // namespace tripus::geometry
