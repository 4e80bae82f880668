/// @file fake_pico: a robot that speaks ROS 1, for tests. It measures in a world of the simulator,
/// and does what it is told for ever. Ends on SIGTERM.
///
/// The journal has a line for each thing worth comparing, with the monotonic time in microseconds:
///     base NANOSECONDS                wall clock at the simulated time 0
///     velocity TIME VX VY VA
///     open_door TIME
///     speak TIME TEXT
///     at TIME X Y A                   each 0.1 s: the robot in the world
#include <chrono>
#include <fstream>
#include <map>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "common/runner/stop_signal.hpp"
#include "tests/process/fake_pico/measurements.hpp"

namespace perceptor::test {
namespace {

template <class Clock, class Duration>
std::int64_t now() {
  return std::chrono::duration_cast<Duration>(Clock::now().time_since_epoch()).count();
}
std::int64_t monotonic() { return now<std::chrono::steady_clock, std::chrono::microseconds>(); }
std::int64_t wall() { return now<std::chrono::system_clock, std::chrono::nanoseconds>(); }

/// [us]
constexpr std::int64_t kJournalPeriod = 100'000;
constexpr auto kPause = std::chrono::milliseconds(1);

class FakePico {
 public:
  FakePico(const FakeOptions& options, const std::string& journal, double broken_period, bool waits)
      : broken_period_(static_cast<std::int64_t>(broken_period * 1e6)),
        journal_(journal),
        start_(start(waits)),
        base_((wall() / 1000 - kStart) * 1000),
        measurements_(options, base_) {
    journal_ << "base " << base_ << std::endl;
  }

  void run() {
    Measurements::Due due = measurements_.next();
    while (!stop_requested()) {
      const std::int64_t simulated = monotonic() - start_ + kStart;
      for (; due.at <= simulated; due = measurements_.next()) {
        if (due.scan) face_.publish(*due.scan);
        if (due.odometry) face_.publish(*due.odometry);
      }
      obey(face_.take_heard());
      send_rubbish();
      tell_where();
      std::this_thread::sleep_for(kPause);
    }
  }

 private:
  static constexpr std::int64_t kStart = 1'000'000;  // [us] where simulations begin

  /// [us, monotonic] When the simulation begins: now, or when somebody listens.
  std::int64_t start(bool waits) const {
    while (waits && !stop_requested() && !face_.is_listened_to())
      std::this_thread::sleep_for(kPause);
    return monotonic();
  }

  void obey(const RosFace::Heard& heard) {
    for (const auto& velocity : heard.velocities) {
      journal_ << "velocity " << monotonic() << ' ' << velocity.vx << ' ' << velocity.vy << ' '
               << velocity.va << std::endl;
      measurements_.simulator().command({velocity.vx, velocity.vy, velocity.va}, {});
    }
    for (int i = 0; i < heard.open_door; ++i) {
      journal_ << "open_door " << monotonic() << std::endl;
      measurements_.simulator().request_door({});
    }
    for (const std::string& text : heard.spoken)
      journal_ << "speak " << monotonic() << ' ' << text << std::endl;
  }

  void send_rubbish() {
    if (broken_period_ == 0 || monotonic() < next_broken_) return;
    next_broken_ = monotonic() + broken_period_;
    face_.publish_broken_scan();
  }

  void tell_where() {
    if (monotonic() < next_line_) return;
    next_line_ = monotonic() + kJournalPeriod;
    const Position robot = measurements_.simulator().truth().robot_in_world;
    journal_ << "at " << monotonic() << ' ' << robot.x << ' ' << robot.y << ' ' << robot.a
             << std::endl;
  }

  std::int64_t broken_period_;  ///< [us] 0: no broken messages
  std::ofstream journal_;
  RosFace face_;
  std::int64_t start_;  ///< [us, monotonic]
  std::int64_t base_;   ///< [ns]
  Measurements measurements_;
  std::int64_t next_line_ = 0;
  std::int64_t next_broken_ = 0;
};

}  // namespace
}  // namespace perceptor::test

int main(int argc, char** argv) {
  using namespace perceptor;
  using namespace perceptor::test;
  FakeOptions options;
  std::string journal = "/dev/null";
  double broken_period = 0.0;
  bool waits = false;
  CLI::App app("A robot that speaks ROS 1, for tests", "fake_pico");
  app.add_option("--world", options.world, "a world file")->required();
  app.add_option("--model", options.model, "whose laser, rate and delays")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Model>{
          {"pico", Model::pico}, {"simulator", Model::simulator}, {"ours", Model::ours}}));
  app.add_option("--miss", options.miss, "how a beam without return is told")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Miss>{
          {"zero", Miss::zero}, {"infinity", Miss::infinity}, {"range_max", Miss::range_max}}));
  app.add_option("--rate", options.rate, "[Hz] of the laser; 0: the model's own");
  app.add_option("--drive", options.drive, "tour, whatever it is told; or command")
      ->transform(CLI::CheckedTransformer(std::map<std::string, sim::Drive>{
          {"tour", sim::Drive::tour}, {"command", sim::Drive::command}}));
  app.add_option("--journal", journal, "the file for what happens");
  app.add_option("--broken-period", broken_period, "[s] between broken scans; 0: none");
  app.add_flag("--wait", waits, "stand until somebody listens, so that nothing is missed");
  CLI11_PARSE(app, argc, argv);
  catch_stop_signals();
  FakePico robot(options, journal, broken_period, waits);
  robot.run();
  return 0;
}
