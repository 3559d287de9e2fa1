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
    for (std::size_t e = 0; e < 6; ++e) {
      store_lanes(out + kLanes * (kAngleMid + e), theta[e].hi);
      store_lanes(out + kLanes * (kAngleLow + e), theta[e].lo);
      store_lanes(out + kLanes * (kAngleRadius + e), theta[e].r);
      sound &= theta[e].r < limit;
    }
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

}  // namespace

extern const EnclosureKernels TRIPUS_ENCLOSURES;
const EnclosureKernels TRIPUS_ENCLOSURES{TRIPUS_KERNELS_NAME, enclose};

}  // namespace tripus::geometry
