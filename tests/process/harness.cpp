#include "tests/process/harness.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"

namespace perceptor::test {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

ScratchFolder::ScratchFolder() {
  std::string pattern = (fs::temp_directory_path() / "perceptor-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path program(const std::string& name) { return fs::path(PERCEPTOR_BIN) / name; }
fs::path source(const std::string& name) { return fs::path(PERCEPTOR_SOURCE) / name; }

Process::Process(const std::vector<std::string>& command, const fs::path& output_file) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0) {
    setpgid(0, 0);
    const int output = open(output_file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    close_range(STDERR_FILENO + 1, ~0U, 0);  // LCM's sockets are the test's, not the child's
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  setpgid(pid_, pid_);
}

Process::~Process() {
  if (exit_code_) return;
  ::kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void Process::signal(int number) const { ::kill(pid_, number); }

std::optional<int> Process::wait(Seconds at_most) {
  const auto give_up = Clock::now() + at_most;
  while (!exit_code_) {
    int state = 0;
    if (waitpid(pid_, &state, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    } else if (Clock::now() > give_up) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  return exit_code_;
}

std::optional<int> Process::stop(Seconds at_most) {
  signal(SIGINT);
  return wait(at_most);
}

Finished run(const std::vector<std::string>& command, Seconds at_most) {
  const ScratchFolder scratch;
  const fs::path output = scratch / "output";
  Process process(command, output);
  Finished finished;
  finished.exit_code = process.wait(at_most).value_or(-1);
  std::ostringstream text;
  text << std::ifstream(output).rdbuf();
  finished.output = text.str();
  return finished;
}

StatusListener::StatusListener() {
  if (!lcm_.good()) throw std::runtime_error("no bus: was the test started by private_bus?");
  lcm_subscribe(
      lcm_.getUnderlyingLCM(), "STATUS_.*",
      [](const lcm_recv_buf_t* buffer, const char*, void* self) {
        pico::status_t status;
        const Bus::Bytes bytes{static_cast<const std::uint8_t*>(buffer->data), buffer->data_size};
        if (detail::decode(bytes, status).empty())
          static_cast<StatusListener*>(self)->last_[status.component] = status;
      },
      this);
}

bool StatusListener::wait_until(const std::function<bool()>& done, Seconds at_most) {
  const auto give_up = Clock::now() + at_most;
  while (!done()) {
    if (Clock::now() > give_up) return false;
    lcm_.handleTimeout(20);
  }
  return true;
}

bool StatusListener::wait_for(const std::vector<std::string>& components, Seconds at_most) {
  return wait_until(
      [&] {
        return std::ranges::all_of(components, [&](const auto& c) { return last_.contains(c); });
      },
      at_most);
}

std::int64_t rejected(const pico::status_t& status, const std::string& channel,
                      const std::string& reason) {
  for (const auto& entry : status.rejects)
    if (entry.channel == channel && entry.reason == reason) return entry.count;
  return 0;
}

std::int64_t received(const pico::status_t& status, const std::string& channel) {
  for (const auto& entry : status.inputs)
    if (entry.channel == channel) return entry.received;
  return 0;
}

std::int64_t published(const pico::status_t& status, const std::string& channel) {
  for (const auto& entry : status.outputs)
    if (entry.channel == channel) return entry.published;
  return 0;
}

Payloads computed_payloads(const fs::path& log) {
  Payloads payloads;
  LogReader reader(log);
  while (const auto event = reader.next()) {
    for (const char* channel : {channel::position, channel::proximity, channel::current_map,
                                channel::local_map, channel::identified_map, channel::entrance,
                                channel::world_position, channel::combined_map})
      if (event->channel == channel) payloads[channel].push_back(event->data);
  }
  return payloads;
}

Recording::Recording(const fs::path& log, const Options& options)
    : logger_({"lcm-logger", "-q", "-f", "-v", "-c", "LCM_SELF_TEST", log.string()}) {
  const auto recording = run({program("pico-watch"), "--wait-log", log.string()});
  if (recording.exit_code != 0) throw std::runtime_error(recording.output);
  std::vector<std::string> names = kPerceiving;
  for (const auto& [name, own] : options)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  for (const std::string& name : names) {
    std::vector<std::string> command{program("pico-" + name)};
    if (const auto own = options.find(name); own != options.end())
      command.insert(command.end(), own->second.begin(), own->second.end());
    components_.push_back(std::make_unique<Process>(command));
  }
  if (!status_.wait_for(names)) throw std::runtime_error("not every component is ready");
}

bool Recording::stop() {
  bool clean = true;
  for (const auto& component : components_) clean &= component->stop() == 0;
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // lcm-logger discards its backlog
  clean &= logger_.stop().has_value();
  return clean;
}

}  // namespace perceptor::test
