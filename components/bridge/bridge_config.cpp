#include "components/bridge/bridge_config.hpp"

namespace perceptor {

void describe(config::Fields& fields, BridgeConfig& config) {
  fields.text(
      "source", config.source,
      R"("sim", the simulator, "log:FILE", an LCM log, or "ros", a robot that speaks ROS 1)");
  fields.text("world", config.world, "of the simulator: a world's name, or its file");
  fields.number("speed", config.speed, {0.0, 1000.0}, "times real time; 0: as fast as it can");
  fields.number("duration", config.duration, {0.0, 1e8},
                "[s] of the source's own time, then stop; 0: for ever");
  fields.integer("session", config.session, {0, INT64_MAX},
                 "number of the session of simulator or robot; 0: the wall clock at start");
  fields.integer("seed", config.seed, {0, INT64_MAX},
                 "of the simulator's random numbers; 0: as the world file says");
  fields.choice("drive", config.drive,
                {{"auto", sim::Drive::automatic},
                 {"tour", sim::Drive::tour},
                 {"command", sim::Drive::command}},
                "who drives the simulated robot; auto: the tour, until a command comes");
  fields.group("ros", config.ros, "the robot, where the source is \"ros\"");
  fields.group("robot", config.robot, "as in robot.json");
}

}  // namespace perceptor
