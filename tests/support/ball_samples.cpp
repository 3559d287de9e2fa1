#include "tests/support/ball_samples.hpp"

#include "geometry/detail/ball_functions.hpp"

namespace tripus::testing {

#ifndef TRIPUS_BALL_SAMPLES
#define TRIPUS_BALL_SAMPLES ball_samples
#endif

BallSamples TRIPUS_BALL_SAMPLES(const std::vector<std::pair<double, double>>& points) {
  using B = geometry::Ball<double>;
  BallSamples samples;
  for (const auto& [x, y] : points) {
    BallSample s{x, y, {}, {}, {}, {}, {}, {}, {}};
    const auto keep = [](double(&to)[2], const B& ball) {
      to[0] = ball.m;
      to[1] = ball.r;
    };
    const auto hyperbolic = geometry::ball_sinh_cosh<double>(x);
    keep(s.sinh, hyperbolic.sinh);
    keep(s.cosh, hyperbolic.cosh);
    keep(s.log, ball_log(B{x, 0}));
    keep(s.angle, angle_of(B{y, 0}, B{x, 0}));
    keep(s.quotient, B{y, 0} / B{x, 0});
    keep(s.root, square_root(B{x, 0}));
    keep(s.clausen, clausen(B{x, 0}));
    samples.push_back(s);
  }
  return samples;
}

}  // namespace tripus::testing
