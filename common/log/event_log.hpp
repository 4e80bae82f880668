/// @file LCM event logs, read so that damage costs as little as possible and is never
/// silent. LCM's own reader stops at the first damaged byte, and crashes on a hostile length.
///
/// One event, all numbers big-endian: magic 0xEDA1DA01, number int64, timestamp int64,
/// channel length int32, data length int32, channel, data.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace perceptor {

/// What LCM allows for the name of a channel.
inline constexpr std::size_t kMaxChannelLength = 63;

/// [bytes] More than any message of ours, enough for another project's camera images. A
/// larger data length is taken for damage.
inline constexpr std::size_t kMaxEventData = std::size_t{64} * 1024 * 1024;

struct LogEvent {
  std::int64_t number = 0;     ///< as the logger counted
  std::int64_t timestamp = 0;  ///< [us] when the logger received it
  std::string channel;
  std::vector<std::uint8_t> data;
};

/// A stretch of the file that held no event.
struct LogDamage {
  std::int64_t offset = 0;  ///< [bytes] from the start of the file
  std::int64_t size = 0;    ///< [bytes] passed over

  friend bool operator==(const LogDamage&, const LogDamage&) = default;
};

/// The file cannot be opened, read or written.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// 1 to kMaxChannelLength printable characters: what a reader takes for a channel.
bool is_channel_name(std::string_view name);

/// Whether the file begins as an event log does, whatever its name; false where it cannot be read.
bool is_event_log(const std::filesystem::path& file);

namespace detail {
struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;
}  // namespace detail

/// Reads forward, through a window of the file that it keeps in memory. It never holds more
/// than one event and some read-ahead, whatever lengths the file claims.
class LogReader {
 public:
  /// Throws LogError.
  explicit LogReader(const std::filesystem::path& file);

  /// The next event that is whole; none at the end. After damage it goes on at the next event
  /// magic that begins a plausible event. Throws LogError where the disk cannot be read.
  ///
  /// An event is plausible where its channel is printable, its lengths are within bounds and
  /// within what is left of the file, and the next event's magic or the end of the file
  /// follows it. Where something else follows, either its own length is damaged or what comes
  /// after it is: it is given up if an undamaged event begins inside its claimed data, and
  /// kept otherwise.
  std::optional<LogEvent> next();

  /// The same into an event whose memory is used again; false at the end, where the event is
  /// left as it was.
  bool next(LogEvent& event);

  /// Goes on at the first event from there on, wherever the offset [bytes] lies.
  void skip_to(std::int64_t offset) { offset_ = offset; }

  /// What was passed over so far, the rest of a truncated last event included.
  const std::vector<LogDamage>& damage() const { return damage_; }

  std::int64_t offset() const { return offset_; }  ///< [bytes] read so far
  std::int64_t size() const { return size_; }      ///< [bytes] of the file when it was opened

 private:
  /// Where an event would lie, were there one at an offset.
  struct Frame {
    std::int64_t offset;
    std::size_t channel_length;
    std::size_t data_length;

    std::int64_t data_offset() const;
    std::int64_t end() const;
  };

  std::size_t read_at(std::int64_t offset, std::uint8_t* out, std::size_t wanted) const;
  std::span<const std::uint8_t> bytes_at(std::int64_t offset, std::size_t wanted);
  bool is_magic_at(std::int64_t offset) const;
  std::int64_t find_magic(std::int64_t from);
  std::optional<Frame> plausible_frame(std::int64_t offset);
  bool is_followed_by_event(const Frame& frame);
  std::int64_t next_certain_event(std::int64_t from);
  bool is_event(const Frame& frame);
  void pass_over(std::int64_t from, std::int64_t to);

  detail::File file_;
  std::int64_t offset_ = 0;
  std::int64_t size_ = 0;
  std::vector<LogDamage> damage_;
  std::vector<std::uint8_t> window_;
  std::int64_t window_offset_ = 0;
  std::size_t window_size_ = 0;
  std::int64_t certain_from_ = -1;  ///< next_certain_event was asked from here, ...
  std::int64_t certain_ = -1;       ///< ... and this was the answer
};

class LogWriter {
 public:
  enum class Mode {
    replace,  ///< a file of that name
    append    ///< behind its last whole event: what a writer that was killed left behind is cut off
  };

  /// Throws LogError.
  explicit LogWriter(const std::filesystem::path& file, Mode mode = Mode::replace);

  /// Keeps the stamp it is given; the event's number is counted here. Throws LogError (disk
  /// full, or a channel or data that no reader would take).
  void write(std::string_view channel, std::int64_t timestamp, const void* data, std::size_t size);

  /// Hands what is buffered to the system: it survives the death of this process. Throws LogError.
  void flush();

  /// Writes out what is buffered; nothing can be written after it. Throws LogError. The
  /// destructor does it without a word.
  void close();

  /// After a LogError: closes, and cuts off what did not go out whole, where the disk still lets
  /// it. Gives how many events are lost: those since the last flush.
  std::int64_t give_up();

  std::int64_t written() const { return written_; }  ///< events
  std::int64_t size() const { return size_; }        ///< [bytes] of the file, with what is buffered

 private:
  std::filesystem::path path_;
  std::string name_;
  detail::File file_;
  std::int64_t written_ = 0;
  std::int64_t size_ = 0;
  std::int64_t flushed_ = 0;  ///< events
  std::int64_t flushed_size_ = 0;
};

}  // namespace perceptor
