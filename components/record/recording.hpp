/// @file A log file that is written while messages come, and survives a full disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/log/event_log.hpp"

namespace perceptor::record {

class Recording {
 public:
  /// Throws LogError where the file cannot be written.
  Recording(const std::filesystem::path& file, LogWriter::Mode mode);

  /// `received_at` [us]. What cannot be written is counted, not thrown.
  void add(std::string_view channel, std::int64_t received_at,
           std::span<const std::uint8_t> payload);

  /// Hands what was added to the system; where writing had failed, tries to go on behind the last
  /// whole event.
  void flush();

  /// Why nothing is written at present; empty: it is.
  const std::string& trouble() const { return trouble_; }

  /// Messages that are not in the file, since this was last asked.
  std::int64_t take_lost();

  std::int64_t size() const { return size_; }  ///< [bytes] of the file

 private:
  void stop(const LogError& error);

  std::filesystem::path file_;
  std::optional<LogWriter> writer_;  ///< none while writing fails
  std::string trouble_;
  std::int64_t lost_ = 0;
  std::int64_t size_ = 0;
};

}  // namespace perceptor::record
