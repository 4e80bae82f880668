/// @file A recording in any format, line by line.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tools/convert/carmen_log.hpp"
#include "tools/convert/recording.hpp"
#include "tools/convert/text_log.hpp"

namespace perceptor {

enum class RecordingFormat { automatic, text, carmen };

/// Reads forward, a line at a time, and holds no more than that.
class RecordingReader {
 public:
  /// `name` is used in what NotARecording says.
  RecordingReader(std::istream& in, RecordingFormat format, std::string name);

  /// What the next line that is not empty gave; none at the end. Throws NotARecording.
  std::optional<ParsedLine> next();

  std::int64_t line() const { return line_; }    ///< of what was given last, from 1
  std::int64_t bytes() const { return bytes_; }  ///< read so far

  /// What a person should know about the lines so far.
  std::vector<std::string> notes() const;

 private:
  enum class Line { none, whole, too_long };
  Line read_line(std::string_view& line);
  ParsedLine parse(std::string_view line);

  std::istream& in_;
  std::string name_;
  std::variant<TextLog, CarmenLog> log_;
  bool is_format_known_;
  std::vector<char> buffer_;
  std::int64_t line_ = 0;
  std::int64_t bytes_ = 0;
};

}  // namespace perceptor
