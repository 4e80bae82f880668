#include "tools/convert/conversion.hpp"

#include <algorithm>
#include <iomanip>
#include <utility>

#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kShownLines = 5;

void count(ConversionSummary& summary, std::int64_t line, const Dropped& dropped) {
  DroppedLines& lines = summary.dropped[dropped.reason];
  ++lines.count;
  if (lines.first.size() < kShownLines)
    lines.first.push_back(std::to_string(line) +
                          (dropped.detail.empty() ? "" : ": " + dropped.detail));
}

/// Whatever the reader reads; `progress` is called after each line.
template <class Reader>
ConversionSummary convert_all(Reader& reader, const std::filesystem::path& out,
                              const ConversionOptions& options, const auto& progress) {
  EventWriter writer(out, options.events);
  ConversionSummary summary;
  const auto drop = [&](const Dropped& dropped) {
    count(summary, reader.line(), dropped);
    writer.count_dropped(dropped.reason);
  };
  while (const auto parsed = reader.next()) {
    if (parsed->odometry) {
      const std::string_view fault = writer.add(*parsed->odometry);
      if (!fault.empty()) drop({fault, {}});
    }
    if (parsed->scan) {
      const std::string_view fault = writer.add(*parsed->scan);
      if (!fault.empty()) drop({fault, {}});
    }
    if (parsed->dropped) drop(*parsed->dropped);
    progress();
  }
  writer.finish();

  summary.lines = reader.line();
  summary.scans = writer.scans();
  summary.odometry = writer.odometry();
  summary.session = writer.session();
  summary.duration = seconds_between(writer.first_utime(), writer.last_utime());
  summary.notes = reader.notes();
  for (std::string& note : writer.notes()) summary.notes.push_back(std::move(note));
  return summary;
}

}  // namespace

ConversionSummary convert(std::istream& in, const std::string& name,
                          const std::filesystem::path& out, const ConversionOptions& options,
                          const std::function<void(std::int64_t bytes)>& progress) {
  RecordingReader reader(in, options.format, name);
  return convert_all(reader, out, options, [&] {
    if (progress) progress(reader.bytes());
  });
}

ConversionSummary convert_bag(const std::filesystem::path& bag, const std::filesystem::path& out,
                              const ConversionOptions& options,
                              const std::function<void(std::int64_t bytes)>& progress) {
  BagFile file = open_bag(
      bag, [topics = options.topics](std::string_view topic) { return topics.is_wanted(topic); });
  const auto size = static_cast<double>(std::filesystem::file_size(bag));
  const double bytes_in_message =
      size / static_cast<double>(std::max<std::int64_t>(1, file.messages));
  BagReader reader(std::move(file), options.topics);
  ConversionSummary summary = convert_all(reader, out, options, [&] {
    const double bytes = bytes_in_message * static_cast<double>(reader.line());
    if (progress) progress(static_cast<std::int64_t>(bytes));
  });
  summary.unit = "message";
  return summary;
}

void print(std::ostream& out, const ConversionSummary& summary) {
  out << summary.lines << ' ' << summary.unit << "s read: " << summary.scans << " scans, "
      << summary.odometry << " odometry";
  if (summary.is_useful())
    out << " written, " << std::fixed << std::setprecision(1) << summary.duration << " s, session "
        << summary.session;
  out << '\n';
  for (const auto& [reason, lines] : summary.dropped) {
    out << "dropped " << lines.count << ", " << reason << ": " << summary.unit;
    if (lines.count > 1) out << 's';
    const char* separator = " ";
    for (const std::string& line : lines.first) {
      out << separator << line;
      separator = "; ";
    }
    if (lines.count > static_cast<std::int64_t>(lines.first.size())) out << "; ...";
    out << '\n';
  }
  for (const std::string& note : summary.notes) out << "note: " << note << '\n';
}

}  // namespace perceptor
