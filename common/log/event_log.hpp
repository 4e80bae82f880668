/// @file LCM event logs, read so that damage costs as little as possible and is never
/// silent. LCM's own reader stops at the first damaged byte, and crashes on a hostile length.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace perceptor {

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
};

/// The file cannot be opened, read or written.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class LogReader {
 public:
  /// Throws LogError.
  explicit LogReader(const std::filesystem::path& file);

  /// The next event that is whole; none at the end. After damage it goes on at the next event
  /// magic that begins a plausible event.
  std::optional<LogEvent> next();

  /// What was passed over so far, the rest of a truncated last event included.
  const std::vector<LogDamage>& damage() const { return damage_; }

  std::int64_t offset() const { return offset_; }  ///< [bytes] read so far
  std::int64_t size() const { return size_; }      ///< [bytes] of the whole file

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  std::int64_t offset_ = 0;
  std::int64_t size_ = 0;
  std::vector<LogDamage> damage_;
};

class LogWriter {
 public:
  /// Throws LogError.
  explicit LogWriter(const std::filesystem::path& file);

  /// Keeps the stamp it is given; the event's number is counted here. Throws LogError (disk
  /// full).
  void write(const std::string& channel, std::int64_t timestamp, const void* data,
             std::size_t size);

  /// Writes out what is buffered. Throws LogError. The destructor does it without a word.
  void close();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  std::int64_t written_ = 0;
};

}  // namespace perceptor
