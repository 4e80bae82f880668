/// @file Real executables on a private bus, for tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>
#include <pico/status_t.hpp>
#include <sys/types.h>

#include "common/log/event_log.hpp"

namespace perceptor::test {

using Seconds = std::chrono::duration<double>;

/// A folder of its own for each test, gone with it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The path of one of our programs, or of a file of the source tree.
std::filesystem::path program(const std::string& name);
std::filesystem::path source(const std::string& name);

/// A child process. Killed, with all its children, when it goes out of scope.
class Process {
 public:
  /// The first word is looked up in PATH; output goes to `output_file` where one is given.
  explicit Process(const std::vector<std::string>& command,
                   const std::filesystem::path& output_file = "/dev/null");
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) const;

  /// The exit code, or 128 + signal; none where it still runs after that long.
  std::optional<int> wait(Seconds at_most);

  /// SIGINT, then wait.
  std::optional<int> stop(Seconds at_most = Seconds(10));

 private:
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
};

struct Finished {
  int exit_code = -1;
  std::string output;  ///< standard output and error
};

/// Runs a command to its end; exit code -1 where it takes longer than `at_most`.
Finished run(const std::vector<std::string>& command, Seconds at_most = Seconds(60));

/// Listens to the STATUS messages on the default bus.
class StatusListener {
 public:
  StatusListener();

  /// Handles messages until `done` says so. False: it did not within `at_most`.
  bool wait_until(const std::function<bool()>& done, Seconds at_most = Seconds(20));

  /// Whether every one of these has been heard.
  bool wait_for(const std::vector<std::string>& components, Seconds at_most = Seconds(20));

  /// The last STATUS of a component; empty fields where none was heard.
  const pico::status_t& last(const std::string& component) { return last_[component]; }

  lcm::LCM& lcm() { return lcm_; }

 private:
  lcm::LCM lcm_;
  std::map<std::string, pico::status_t> last_;
};

std::int64_t rejected(const pico::status_t& status, const std::string& channel,
                      const std::string& reason);
std::int64_t received(const pico::status_t& status, const std::string& channel);
std::int64_t published(const pico::status_t& status, const std::string& channel);

/// The payloads of each data channel that locate, proximity, scan, merge and identify publish.
using Payloads = std::map<std::string, std::vector<std::vector<std::uint8_t>>>;
Payloads computed_payloads(const std::filesystem::path& log);

/// The five perceiving processes, others that the options name, and lcm-logger, started in order;
/// stopped in order.
class Recording {
 public:
  /// What each component gets on its command line beside its name; {"scan", {"--set", "a=b"}}.
  using Options = std::map<std::string, std::vector<std::string>>;

  explicit Recording(const std::filesystem::path& log, const Options& options = {});

  /// Sends SIGINT to each in turn, the logger last, and waits. True: all ended cleanly.
  bool stop();

  StatusListener& status() { return status_; }

 private:
  StatusListener status_;
  Process logger_;
  std::vector<std::unique_ptr<Process>> components_;
};

inline const std::vector<std::string> kPerceiving = {"locate", "proximity", "scan", "merge",
                                                     "identify"};

}  // namespace perceptor::test
