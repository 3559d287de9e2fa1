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

Arb clausen(const Arb& x) {
  const Arb reduced = within_a_turn(x);
  Arb result;
  if (arb_contains_zero(reduced.get()) != 0) {
    // |Cl2(a)| <= |a| (1 - ln |a|) + |a|^3 / 60 <= sqrt |a| * 3 on |a| <= 1.
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, reduced.get());
    if (mag_cmp_2exp_si(bound, 0) > 0) {
      mag_inf(bound);
    } else {
      mag_sqrt(bound, bound);
      mag_mul_ui(bound, bound, 3);
    }
    arb_zero(result.get());
    mag_set(arb_radref(result.get()), bound);
    mag_clear(bound);
    return result;
  }
  acb_t z;
  acb_init(z);
  arb_sin_cos(acb_imagref(z), acb_realref(z), reduced.get(), Precision::bits());
  acb_hypgeom_dilog(z, z, Precision::bits());
  arb_set(result.get(), acb_imagref(z));
  acb_clear(z);
  return result;
}

}  // namespace tripus::structure::detail
