/// @file The records of a recording as messages in an LCM event log.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/status.hpp"
#include "common/log/event_log.hpp"
#include "tools/convert/recording.hpp"

namespace perceptor {

struct EventWriterOptions {
  std::optional<std::int64_t> session;   ///< none: the first record's utime
  double range_sigma = 0.01;             ///< [m] standard deviation of a valid range
  std::optional<double> time_increment;  ///< [s] instead of what is recorded; 0: all at once
  std::optional<double> valid_min;       ///< [m] instead of what is recorded
  std::optional<double> valid_max;       ///< [m] instead of what is recorded
  bool still = false;                    ///< odometry of zeros instead of what is recorded
};

/// Writes PICO_LASER, PICO_ODOMETRY and, at the end, one STATUS_CONVERT that counts them, so
/// that pico-logcheck can prove the log complete. An event's stamp is the latest utime so far:
/// a log's stamps only go forward, while utimes stay as recorded. The same records give the
/// same bytes.
///
/// A robot that stands still gets an odometry at each scan's own utime, which alone decides
/// the scan's position however far apart the scans are, and one before the first scan and
/// after the last, so that each scan has odometry on both sides.
class EventWriter {
 public:
  /// The file is begun with the first message: a recording without any leaves no file, and
  /// one of that name as it is.
  EventWriter(std::filesystem::path file, const EventWriterOptions& options);

  /// Why the record was not written; empty: it was. Throws LogError.
  std::string_view add(const OdometryRecord& odometry);
  std::string_view add(const ScanRecord& scan);

  /// Lines that were dropped so far, for STATUS.
  void count_dropped(std::string_view reason);

  /// Writes what belongs at the end. Throws LogError.
  void finish();

  std::int64_t scans() const { return scans_; }
  std::int64_t odometry() const { return odometry_; }
  std::int64_t session() const { return session_; }
  std::int64_t first_utime() const { return first_utime_; }
  std::int64_t last_utime() const { return last_utime_; }

  /// What a person should know.
  std::vector<std::string> notes() const;

 private:
  template <class Message>
  std::string_view write(const char* channel, Message& message);
  void begin(std::int64_t utime);
  void write_standing(std::int64_t utime);

  std::filesystem::path file_;
  EventWriterOptions options_;
  std::optional<LogWriter> log_;
  std::optional<Status> status_;
  std::map<std::string_view, std::int64_t> dropped_;
  std::int64_t session_ = 0;
  std::int64_t first_utime_ = 0;
  std::int64_t last_utime_ = 0;  ///< the latest so far
  std::int64_t scans_ = 0;
  std::int64_t odometry_ = 0;
  std::optional<std::int64_t> last_standing_;
  std::optional<double> derived_valid_min_;
  std::optional<double> derived_valid_max_;
};

}  // namespace perceptor
