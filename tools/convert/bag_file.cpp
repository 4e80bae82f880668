/// rosbag_storage believes a bag's index, and a damaged one can crash it. So it reads in a process
/// of its own, which hands the messages on: what it read until then is kept.
#include "tools/convert/bag_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/convert/recording.hpp"

namespace perceptor {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Pipe = std::unique_ptr<std::FILE, CloseFile>;

// What goes through the pipe: first why the bag cannot be read (empty: it can) and the number of
// its messages, then four parts for each message. A part is its length and its bytes; an empty one
// may have no address, which fwrite and fread must not be given.

template <class Bytes>
void write_part(std::FILE* pipe, const Bytes& bytes) {
  const std::uint64_t size = bytes.size();
  std::fwrite(&size, sizeof(size), 1, pipe);
  if (!bytes.empty()) std::fwrite(bytes.data(), 1, bytes.size(), pipe);
}

/// False where the pipe has ended before.
template <class Bytes>
bool read_part(std::FILE* pipe, Bytes& bytes) {
  std::uint64_t size = 0;
  if (std::fread(&size, sizeof(size), 1, pipe) != 1) return false;
  bytes.resize(size);
  return bytes.empty() || std::fread(bytes.data(), 1, bytes.size(), pipe) == bytes.size();
}

std::vector<std::uint8_t> bytes_of(const rosbag::MessageInstance& message) {
  std::vector<std::uint8_t> bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  return bytes;
}

using IsWanted = std::function<bool(std::string_view topic)>;

void hand_on(rosbag::View& view, const IsWanted& is_wanted, std::FILE* pipe) {
  for (const rosbag::MessageInstance& instance : view) {
    BagMessage message{instance.getTopic(), instance.getDataType(), {}, {}};
    try {
      if (is_wanted(message.topic)) message.bytes = bytes_of(instance);
    } catch (const std::exception& error) {
      message.fault = error.what();
    }
    write_part(pipe, message.topic);
    write_part(pipe, message.type);
    write_part(pipe, message.bytes);
    write_part(pipe, message.fault);
  }
}

/// The life of the reading process.
void read_all(const std::string& file, const IsWanted& is_wanted, std::FILE* pipe) {
  std::string fault;
  try {
    const rosbag::Bag bag(file);
    rosbag::View view(bag);
    const std::string count = std::to_string(view.size());
    write_part(pipe, fault);
    write_part(pipe, count);
    hand_on(view, is_wanted, pipe);
    return;
  } catch (const rosbag::BagUnindexedException&) {
    fault = "it has no index, because it was not closed: rosbag reindex";
  } catch (const std::exception& error) {
    fault = error.what();
  }
  write_part(pipe, fault);
}

class ReadingProcess {
 public:
  ReadingProcess(const std::string& file, const IsWanted& is_wanted) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ == 0) {
      close(ends[0]);
      std::FILE* out = fdopen(ends[1], "w");
      read_all(file, is_wanted, out);
      std::fflush(out);
      _exit(0);
    }
    close(ends[1]);
    pipe_.reset(fdopen(ends[0], "r"));
  }
  ~ReadingProcess() {
    pipe_.reset();
    ended_well();
  }
  ReadingProcess(const ReadingProcess&) = delete;
  ReadingProcess& operator=(const ReadingProcess&) = delete;

  std::FILE* pipe_end() const { return pipe_.get(); }

  /// Waits for its end, once the pipe has come to its own; true where it had been waited for.
  bool ended_well() {
    int state = 0;
    const bool is_new = pid_ > 0 && waitpid(std::exchange(pid_, 0), &state, 0) > 0;
    return !is_new || (WIFEXITED(state) && WEXITSTATUS(state) == 0);
  }

 private:
  pid_t pid_ = 0;
  Pipe pipe_;
};

}  // namespace

BagFile open_bag(const std::filesystem::path& file, const IsWanted& is_wanted) {
  const auto reading = std::make_shared<ReadingProcess>(file.string(), is_wanted);
  std::string fault = "rosbag_storage crashed on it";
  std::string count;
  const bool is_told = read_part(reading->pipe_end(), fault);
  if (!is_told || !fault.empty() || !read_part(reading->pipe_end(), count))
    throw NotARecording(file.string() + " is no bag that can be read: " + fault);
  BagFile bag;
  bag.messages = std::stoll(count);
  bag.next = [reading]() -> std::optional<BagMessage> {
    BagMessage message;
    std::FILE* pipe = reading->pipe_end();
    if (read_part(pipe, message.topic) && read_part(pipe, message.type) &&
        read_part(pipe, message.bytes) && read_part(pipe, message.fault))
      return message;
    if (reading->ended_well()) return std::nullopt;
    return BagMessage{{}, {}, {}, "rosbag_storage crashed: the rest is lost"};
  };
  return bag;
}

}  // namespace perceptor
