#include "tools/convert/recording_reader.hpp"

#include <array>
#include <limits>
#include <utility>

#include "tools/convert/words.hpp"

namespace perceptor {
namespace {

/// [bytes] Several times the largest scan that a message carries.
constexpr std::size_t kMaxLine = std::size_t{1} << 20U;

struct Signature {
  std::string_view bytes;
  std::string_view what;
  std::string_view unpack;  ///< a command; empty: there is none
};

constexpr std::array<Signature, 6> kSignatures = {{
    {"\xFD"
     "7zXZ",
     "compressed with xz", "xz -dc"},
    {"\x1F\x8B", "compressed with gzip", "gzip -dc"},
    {"BZh", "compressed with bzip2", "bzip2 -dc"},
    {"\x28\xB5\x2F\xFD", "compressed with zstd", "zstd -dc"},
    {"\xED\xA1\xDA\x01", "an LCM event log already", ""},
    {"#ROSBAG", "a ROS bag, which is read from a file and not from a pipe", ""},
}};

void require_text(std::string_view first_line, const std::string& name) {
  for (const Signature& signature : kSignatures) {
    if (!first_line.starts_with(signature.bytes)) continue;
    std::string text = name + " is " + std::string(signature.what);
    const std::string unpack =
        "\n  " + std::string(signature.unpack) + " " + (name == "-" ? "FILE" : name);
    const bool holds_bag = name.find(".bag") != std::string::npos;
    if (!signature.unpack.empty() && holds_bag)
      text += ". Unpack it first:" + unpack + " > FILE.bag\n  pico-convert FILE.bag OUT.lcmlog";
    else if (!signature.unpack.empty())
      text += ". Unpack it on the way in:" + unpack + " | pico-convert - OUT.lcmlog";
    throw NotARecording(text);
  }
}

/// CARMEN and the text format share ODOM, with other numbers behind it: four there, nine with
/// the host's name here.
bool is_carmen_line(std::string_view line) {
  constexpr int words_in_text_odometry = 5;
  Words words(line);
  const std::string_view keyword = words.word();
  if (keyword != "ODOM") return is_carmen_keyword(keyword);
  int count = 1;
  while (!words.word().empty()) ++count;
  return count > words_in_text_odometry;
}

}  // namespace

RecordingReader::RecordingReader(std::istream& in, RecordingFormat format, std::string name)
    : in_(in),
      name_(std::move(name)),
      is_format_known_(format != RecordingFormat::automatic),
      buffer_(kMaxLine) {
  if (format == RecordingFormat::carmen) log_.emplace<CarmenLog>();
}

RecordingReader::Line RecordingReader::read_line(std::string_view& line) {
  in_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  const auto taken = static_cast<std::size_t>(in_.gcount());
  bytes_ += static_cast<std::int64_t>(taken);
  if (taken == 0 && in_.eof()) return Line::none;
  ++line_;
  const bool has_end = !in_.eof() && !in_.fail();
  line = {buffer_.data(), taken - (has_end ? 1 : 0)};
  if (in_.bad()) return Line::none;
  const bool is_too_long = in_.fail() && !in_.eof();
  if (!is_too_long) return Line::whole;
  in_.clear();
  in_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  bytes_ += static_cast<std::int64_t>(in_.gcount());
  return Line::too_long;
}

ParsedLine RecordingReader::parse(std::string_view line) {
  // Until a line decides, only comments have come; the text format reads its header there,
  // and CARMEN has none.
  const std::string_view keyword = Words(line).word();
  if (!is_format_known_ && !keyword.empty() && !keyword.starts_with('#')) {
    if (is_carmen_line(line)) log_.emplace<CarmenLog>();
    is_format_known_ = true;
  }
  return std::visit([line](auto& log) { return log.parse(line); }, log_);
}

std::optional<ParsedLine> RecordingReader::next() {
  std::string_view line;
  for (Line got = read_line(line); got != Line::none; got = read_line(line)) {
    if (line_ == 1) require_text(line, name_);
    ParsedLine parsed;
    if (got == Line::too_long)
      parsed.dropped = Dropped{drop_reason::too_long, std::string(line.substr(0, 40))};
    else
      parsed = parse(line);
    if (!parsed.empty()) return parsed;
  }
  return {};
}

std::vector<std::string> RecordingReader::notes() const {
  const auto* carmen = std::get_if<CarmenLog>(&log_);
  return carmen ? carmen->notes() : std::vector<std::string>{};
}

}  // namespace perceptor
