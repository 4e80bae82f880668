#include "common/log/event_log.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace perceptor {
namespace {

constexpr std::uint32_t kMagic = 0xEDA1DA01U;
constexpr std::array<std::uint8_t, 4> kMagicBytes = {0xED, 0xA1, 0xDA, 0x01};
constexpr std::size_t kHeaderSize = 4 + 8 + 8 + 4 + 4;
constexpr std::size_t kReadAhead = std::size_t{256} * 1024;

template <class Integer>
Integer load(const std::uint8_t* bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Integer); ++i) value = (value << 8U) | bytes[i];
  return static_cast<Integer>(value);
}

template <class Integer>
std::uint8_t* store(std::uint8_t* out, Integer integer) {
  const auto value = static_cast<std::uint64_t>(integer);
  for (std::size_t i = sizeof(Integer); i-- > 0;)
    *out++ = static_cast<std::uint8_t>(value >> (8U * i));
  return out;
}

bool is_printable(std::span<const std::uint8_t> text) {
  return std::ranges::all_of(text, [](std::uint8_t c) { return c >= 0x20 && c < 0x7F; });
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

[[noreturn]] void fail(const std::string& what) {
  throw LogError(what + ": " + std::generic_category().message(errno));
}

void cut_off(const std::filesystem::path& file, std::int64_t size) {
  std::error_code error;
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(size), error);
  if (error) throw LogError("cannot write " + file.string() + ": " + error.message());
}

/// [bytes] Looks at the end of the file only. Where that holds no event nothing is cut off.
std::int64_t end_of_whole_events(const std::filesystem::path& file) {
  constexpr std::int64_t kEnd = 1024 * 1024;
  LogReader reader(file);
  reader.skip_to(std::max<std::int64_t>(0, reader.size() - kEnd));
  LogEvent event;
  bool has_event = false;
  while (reader.next(event)) has_event = true;
  if (!has_event || reader.damage().empty()) return reader.size();
  const LogDamage& last = reader.damage().back();
  return last.offset + last.size == reader.size() ? last.offset : reader.size();
}

}  // namespace

bool is_channel_name(std::string_view name) {
  return !name.empty() && name.size() <= kMaxChannelLength && is_printable(bytes_of(name));
}

bool is_event_log(const std::filesystem::path& file) {
  const detail::File opened(std::fopen(file.c_str(), "rb"));
  std::array<std::uint8_t, kMagicBytes.size()> bytes{};
  return opened && std::fread(bytes.data(), bytes.size(), 1, opened.get()) == 1 &&
         bytes == kMagicBytes;
}

std::int64_t LogReader::Frame::data_offset() const {
  return offset + static_cast<std::int64_t>(kHeaderSize + channel_length);
}

std::int64_t LogReader::Frame::end() const {
  return data_offset() + static_cast<std::int64_t>(data_length);
}

LogReader::LogReader(const std::filesystem::path& file)
    : file_(std::fopen(file.c_str(), "rb")), window_(kReadAhead) {
  if (!file_) fail("cannot open " + file.string());
  struct stat status {};
  if (fstat(fileno(file_.get()), &status) != 0) fail("cannot open " + file.string());
  if (!S_ISREG(status.st_mode)) throw LogError(file.string() + " is not a regular file");
  size_ = status.st_size;
}

/// Past the window, straight from the file; fewer bytes only at the end of the file.
std::size_t LogReader::read_at(std::int64_t offset, std::uint8_t* out, std::size_t wanted) const {
  std::size_t got = 0;
  while (got < wanted) {
    const ssize_t n = pread(fileno(file_.get()), out + got, wanted - got,
                            offset + static_cast<std::int64_t>(got));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("cannot read the log");
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  return got;
}

/// Up to `wanted` bytes at an offset: fewer only at the end of the file. Valid until the next
/// call.
std::span<const std::uint8_t> LogReader::bytes_at(std::int64_t offset, std::size_t wanted) {
  const std::int64_t window_end = window_offset_ + static_cast<std::int64_t>(window_size_);
  const auto left = static_cast<std::size_t>(std::max<std::int64_t>(size_ - offset, 0));
  wanted = std::min(wanted, left);
  const bool begins_inside = offset >= window_offset_ && offset <= window_end;
  const std::size_t kept =
      begins_inside ? static_cast<std::size_t>(window_end - offset) : std::size_t{0};
  if (kept < wanted) {
    const std::size_t target = std::min(std::max(wanted, kReadAhead), left);
    if (begins_inside) {
      std::memmove(window_.data(), window_.data() + (offset - window_offset_), kept);
    }
    // One huge event must not keep its memory for the rest of the file.
    if (window_.size() < target || window_.size() > 16 * target) {
      window_.resize(std::max(target, kReadAhead));
      if (window_.size() == kReadAhead) window_.shrink_to_fit();
    }
    const std::size_t got =
        read_at(offset + static_cast<std::int64_t>(kept), window_.data() + kept, target - kept);
    window_offset_ = offset;
    window_size_ = kept + got;
    // The file became shorter while it was read: what is gone is damage like any other.
    if (got < target - kept) size_ = offset + static_cast<std::int64_t>(window_size_);
  }
  const auto begin = static_cast<std::size_t>(offset - window_offset_);
  return std::span(window_).subspan(begin, std::min(wanted, window_size_ - begin));
}

bool LogReader::is_magic_at(std::int64_t offset) const {
  std::array<std::uint8_t, kMagicBytes.size()> bytes{};
  const std::int64_t in_window = offset - window_offset_;
  if (in_window >= 0 && in_window + static_cast<std::int64_t>(bytes.size()) <=
                            static_cast<std::int64_t>(window_size_))
    std::copy_n(window_.begin() + in_window, bytes.size(), bytes.begin());
  else
    read_at(offset, bytes.data(), bytes.size());
  return bytes == kMagicBytes;
}

/// The next place at or after `from` that holds the magic; the end of the file if none does.
std::int64_t LogReader::find_magic(std::int64_t from) {
  while (from < size_) {
    const auto bytes = bytes_at(from, kReadAhead / 2);
    const auto found = std::ranges::search(bytes, kMagicBytes);
    if (!found.empty()) return from + (found.begin() - bytes.begin());
    if (bytes.size() < kMagicBytes.size()) break;
    from += static_cast<std::int64_t>(bytes.size() - (kMagicBytes.size() - 1));
  }
  return size_;
}

std::optional<LogReader::Frame> LogReader::plausible_frame(std::int64_t offset) {
  const auto header = bytes_at(offset, kHeaderSize + kMaxChannelLength);
  if (header.size() < kHeaderSize || load<std::uint32_t>(header.data()) != kMagic) return {};
  const auto channel_length = load<std::uint32_t>(header.data() + 20);
  const auto data_length = load<std::uint32_t>(header.data() + 24);
  if (channel_length < 1 || channel_length > kMaxChannelLength) return {};
  if (data_length > kMaxEventData) return {};
  const Frame frame{offset, channel_length, data_length};
  if (frame.end() > size_) return {};
  if (!is_printable(header.subspan(kHeaderSize, channel_length))) return {};
  return frame;
}

bool LogReader::is_followed_by_event(const Frame& frame) {
  // Brings the event in with what follows. Of a larger one, the length has to be believable
  // before it is read.
  const auto length = static_cast<std::size_t>(frame.end() - frame.offset);
  if (length + kMagicBytes.size() <= kReadAhead)
    bytes_at(frame.offset, length + kMagicBytes.size());
  return frame.end() == size_ || is_magic_at(frame.end());
}

/// The first plausible event at or after `from` that is followed by another or by the end of
/// the file; the end of the file if there is none. The last answer is kept, so that a file of
/// nothing but false magics costs one pass.
std::int64_t LogReader::next_certain_event(std::int64_t from) {
  if (certain_from_ >= 0 && certain_from_ <= from && from <= certain_) return certain_;
  certain_from_ = from;
  for (certain_ = find_magic(from); certain_ < size_; certain_ = find_magic(certain_ + 1)) {
    const auto frame = plausible_frame(certain_);
    if (frame && is_followed_by_event(*frame)) break;
  }
  return certain_;
}

bool LogReader::is_event(const Frame& frame) {
  return is_followed_by_event(frame) || next_certain_event(frame.data_offset()) >= frame.end();
}

void LogReader::pass_over(std::int64_t from, std::int64_t to) {
  if (!damage_.empty() && damage_.back().offset + damage_.back().size == from)
    damage_.back().size += to - from;
  else
    damage_.push_back({from, to - from});
}

std::optional<LogEvent> LogReader::next() {
  LogEvent event;
  if (!next(event)) return {};
  return event;
}

bool LogReader::next(LogEvent& event) {
  while (offset_ < size_) {
    const auto frame = plausible_frame(offset_);
    if (frame && is_event(*frame)) {
      const auto length = static_cast<std::size_t>(frame->end() - frame->offset);
      const auto bytes = bytes_at(frame->offset, length);
      if (bytes.size() == length) {
        const auto channel = bytes.subspan(kHeaderSize, frame->channel_length);
        const auto data = bytes.subspan(kHeaderSize + frame->channel_length);
        event.number = load<std::int64_t>(bytes.data() + 4);
        event.timestamp = load<std::int64_t>(bytes.data() + 12);
        event.channel.assign(channel.begin(), channel.end());
        event.data.assign(data.begin(), data.end());
        offset_ = frame->end();
        return true;
      }
    }
    const std::int64_t resume = find_magic(offset_ + 1);
    pass_over(offset_, resume);
    offset_ = resume;
  }
  return false;
}

LogWriter::LogWriter(const std::filesystem::path& file, Mode mode)
    : path_(file), name_(file.string()) {
  const bool goes_on = mode == Mode::append && std::filesystem::exists(file);
  if (goes_on) size_ = flushed_size_ = end_of_whole_events(file);
  if (goes_on) cut_off(file, size_);
  file_.reset(std::fopen(file.c_str(), goes_on ? "ab" : "wb"));
  if (!file_) fail("cannot write " + name_);
  std::setvbuf(file_.get(), nullptr, _IOFBF, kReadAhead);
}

void LogWriter::write(std::string_view channel, std::int64_t timestamp, const void* data,
                      std::size_t size) {
  if (!file_) throw LogError("cannot write " + name_ + ": it is closed");
  if (!is_channel_name(channel))
    throw LogError("cannot write " + name_ + ": \"" + std::string(channel) +
                   "\" is no name for a channel");
  if (size > kMaxEventData)
    throw LogError("cannot write " + name_ + ": a message of " + std::to_string(size) +
                   " bytes on " + std::string(channel));
  std::array<std::uint8_t, kHeaderSize> header;
  std::uint8_t* out = store(header.data(), kMagic);
  out = store(out, written_);
  out = store(out, timestamp);
  out = store(out, static_cast<std::uint32_t>(channel.size()));
  store(out, static_cast<std::uint32_t>(size));
  const bool good = std::fwrite(header.data(), header.size(), 1, file_.get()) == 1 &&
                    std::fwrite(channel.data(), channel.size(), 1, file_.get()) == 1 &&
                    (size == 0 || std::fwrite(data, size, 1, file_.get()) == 1);
  if (!good) fail("cannot write " + name_);
  ++written_;
  size_ += static_cast<std::int64_t>(header.size() + channel.size() + size);
}

void LogWriter::flush() {
  if (!file_) return;
  if (std::fflush(file_.get()) != 0) fail("cannot write " + name_);
  flushed_ = written_;
  flushed_size_ = size_;
}

std::int64_t LogWriter::give_up() {
  file_.reset();
  std::error_code ignored;  // then a reader passes over the rest, and tells
  std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(flushed_size_), ignored);
  return written_ - flushed_;
}

void LogWriter::close() {
  if (!file_) return;
  std::FILE* file = file_.release();
  if (std::fclose(file) != 0) fail("cannot write " + name_);
}

}  // namespace perceptor
