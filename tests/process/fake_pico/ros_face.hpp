/// @file A robot's topics in ROS 1, apart from what it measures. C++17, as ROS's headers need.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace perceptor::test {

class RosFace {
 public:
  struct Scan {
    std::int64_t stamp = 0;  ///< [ns]
    double angle_min = 0.0;
    double angle_max = 0.0;
    double angle_increment = 0.0;
    double time_increment = 0.0;
    double range_min = 0.0;
    double range_max = 0.0;
    std::vector<float> ranges;
  };
  struct Odometry {
    std::int64_t stamp = 0;  ///< [ns]
    double x = 0.0;
    double y = 0.0;
    double a = 0.0;
  };
  struct Velocity {
    double vx = 0.0;
    double vy = 0.0;
    double va = 0.0;
  };
  /// What came since it was last asked.
  struct Heard {
    std::vector<Velocity> velocities;
    int open_door = 0;  ///< times
    std::vector<std::string> spoken;
  };

  /// Waits for the master that ROS_MASTER_URI names.
  RosFace();
  ~RosFace();
  RosFace(const RosFace&) = delete;
  RosFace& operator=(const RosFace&) = delete;

  void publish(const Scan& scan);
  void publish(const Odometry& odometry);
  /// Bytes that are no LaserScan, on the laser's topic.
  void publish_broken_scan();
  Heard take_heard();

  /// Somebody listens to laser and odometry.
  bool is_listened_to() const;

 private:
  struct Topics;
  std::unique_ptr<Topics> topics_;
};

}  // namespace perceptor::test
