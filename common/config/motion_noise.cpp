#include "common/config/motion_noise.hpp"

namespace perceptor {

void describe(config::Fields& fields, MotionNoise& noise) {
  constexpr config::Range kSigma{1e-5, 1.0};
  fields.number("translation", noise.translation, kSigma,
                "[m/sqrt(m)] of the way after one metre; larger trusts the walls more");
  fields.number("heading", noise.heading, kSigma,
                "[rad/sqrt(rad)] of the heading after turning by one radian");
  fields.number("heading_by_translation", noise.heading_by_translation, kSigma,
                "[rad/sqrt(m)] of the heading after driving one metre");
  fields.number("still", noise.still, kSigma, "[m/sqrt(s), rad/sqrt(s)] with time alone");
}

}  // namespace perceptor
