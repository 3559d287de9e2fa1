#include "structure/proof/detail/arb_number.hpp"

namespace tripus::structure::detail {
namespace {

/// x less the multiple of 2 pi nearest to its midpoint.
Arb within_a_turn(const Arb& x) {
  const Arb turn = 2.0 * number_pi(x);
  Arb quotient = x / turn;
  fmpz_t turns;
  fmpz_init(turns);
  arf_get_fmpz(turns, arb_midref(quotient.get()), ARF_RND_NEAR);
  Arb count;
  arb_set_fmpz(count.get(), turns);
  fmpz_clear(turns);
  return x - count * turn;
}

}  // namespace

Precision::Precision(long bits) : before_(std::exchange(bits_, bits)) {
  // FLINT keeps memory for each thread, which nobody else gives back when the thread ends.
  struct Caches {
    Caches() = default;
    Caches(const Caches&) = delete;
    Caches& operator=(const Caches&) = delete;
    ~Caches() { flint_cleanup(); }
  };
  static thread_local const Caches kCaches;
  static_cast<void>(&kCaches);
}

Arb clausen_near_zero(const Arb& a) {
  // |Cl2(x)| <= |x| (1 - ln |x|) + |x|^3 / 60 < |x| (2 - ln |x|), which grows on |x| <= 1.
  mag_t size, bound;
  mag_init(size);
  mag_init(bound);
  arb_get_mag(size, a.get());
  if (mag_cmp_2exp_si(size, 0) > 0) {
    mag_inf(bound);
  } else if (mag_is_zero(size) == 0) {
    mag_neg_log(bound, size);
    mag_add_ui(bound, bound, 2);
    mag_mul(bound, bound, size);
  }
  Arb result;
  mag_set(arb_radref(result.get()), bound);
  mag_clear(size);
  mag_clear(bound);
  return result;
}

Arb clausen(const Arb& x) {
  const Arb reduced = within_a_turn(x);
  if (arb_contains_zero(reduced.get()) != 0) return clausen_near_zero(reduced);
  Arb result;
  acb_t z;
  acb_init(z);
  arb_sin_cos(acb_imagref(z), acb_realref(z), reduced.get(), Precision::bits());
  acb_hypgeom_dilog(z, z, Precision::bits());
  arb_set(result.get(), acb_imagref(z));
  acb_clear(z);
  return result;
}

}  // namespace tripus::structure::detail
