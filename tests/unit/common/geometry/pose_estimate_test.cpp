#include "common/geometry/pose_estimate.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

TEST(Prediction, FollowsOdometryAndGrowsUncertain) {
  const PoseEstimate start{{1.0, 2.0, std::numbers::pi / 2.0}, Eigen::Matrix3d::Zero()};
  const PoseEstimate moved = predict(start, {1.0, 0.0, 0.1}, 2.0, {});
  EXPECT_NEAR(moved.pose.x, 1.0, 1e-12);
  EXPECT_NEAR(moved.pose.y, 3.0, 1e-12);
  EXPECT_NEAR(std::sqrt(moved.covariance(0, 0)), 0.05, 0.001);
  EXPECT_GT(moved.covariance(2, 2), 0.0);
}

TEST(Prediction, HeadingErrorBecomesSidewaysErrorWithTheWay) {
  PoseEstimate start;
  start.covariance(2, 2) = 0.01;
  const PoseEstimate moved = predict(start, {2.0, 0.0, 0.0}, 1.0, {});
  EXPECT_GT(moved.covariance(1, 1), 0.04);
  EXPECT_LT(moved.covariance(0, 0), 0.01);
}

TEST(Prediction, DoesNotDependOnHowOftenItIsAsked) {
  PoseEstimate often;
  for (int i = 0; i < 100; ++i) often = predict(often, {0.01, 0.0, 0.0}, 0.01, {});
  const PoseEstimate once = predict({}, {1.0, 0.0, 0.0}, 1.0, {});
  EXPECT_NEAR(often.covariance(0, 0), once.covariance(0, 0), 1e-9);
  EXPECT_NEAR(often.covariance(2, 2), once.covariance(2, 2), 1e-9);
}

}  // namespace
}  // namespace perceptor
