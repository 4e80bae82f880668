#include "tools/eval/line_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <zlib.h>

namespace perceptor {
namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::size_t kBlockSize = 65536;      // [bytes]
constexpr std::size_t kLongestLine = 4000000;  // [bytes] a scan of 100 000 beams has 800 kB
constexpr std::size_t kMostQuoted = 40;        // characters of a wrong word

template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

void LineReader::Close::operator()(gzFile_s* file) const { gzclose(file); }

LineReader::LineReader(const std::filesystem::path& file)
    : name_(file.string()), file_(gzopen(name_.c_str(), "rb")), block_(kBlockSize) {
  if (!file_) throw TextFileError("cannot open " + name_);
}

bool LineReader::refill() {
  const int got = gzread(file_.get(), block_.data(), static_cast<unsigned>(block_.size()));
  int error = Z_OK;
  const char* reason = gzerror(file_.get(), &error);
  // A gzip stream that is cut off gives what it has, and then this error instead of the end.
  const bool is_cut_off = got == 0 && error == Z_BUF_ERROR;
  if (got < 0 || is_cut_off)
    throw TextFileError("cannot read " + name_ + " beyond line " + std::to_string(line_number_) +
                        ": " + (is_cut_off ? "it is cut off" : reason));
  block_begin_ = 0;
  block_end_ = static_cast<std::size_t>(got);
  return got > 0;
}

bool LineReader::read_line() {
  line_.clear();
  bool is_there = false;
  while (block_begin_ < block_end_ || refill()) {
    is_there = true;
    const char* begin = block_.data() + block_begin_;
    const char* end = block_.data() + block_end_;
    const char* newline = std::find(begin, end, '\n');
    line_.append(begin, newline);
    block_begin_ += static_cast<std::size_t>(newline - begin) + (newline != end ? 1 : 0);
    if (line_.size() > kLongestLine)
      throw TextFileError(name_ + ":" + std::to_string(line_number_ + 1) + ": the line is endless");
    if (newline != end) break;
  }
  if (is_there) ++line_number_;
  rest_ = line_;
  last_word_ = {};
  return is_there;
}

bool LineReader::next() {
  while (read_line()) {
    const std::size_t begin = rest_.find_first_not_of(kBlank);
    if (begin != std::string_view::npos && rest_[begin] != '#') return true;
  }
  return false;
}

void LineReader::fail(std::string_view expected) const {
  std::string message = name_ + ":" + std::to_string(line_number_) + ": expected ";
  message.append(expected);
  if (last_word_.empty()) {
    message += ", the line ends";
  } else {
    message.append(", found \"").append(last_word_.substr(0, kMostQuoted)).append("\"");
  }
  throw TextFileError(message);
}

std::string_view LineReader::word(std::string_view what) {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
  last_word_ = rest_.substr(0, rest_.find_first_of(kBlank));
  rest_.remove_prefix(last_word_.size());
  if (last_word_.empty()) fail(what);
  return last_word_;
}

double LineReader::number(std::string_view what) {
  double value = 0.0;
  if (!parse(word(what), value)) fail(what);
  return value;
}

double LineReader::finite(std::string_view what) {
  const double value = number(what);
  if (!std::isfinite(value)) fail(what);
  return value;
}

void LineReader::finite(std::initializer_list<double*> values, std::string_view what) {
  for (double* value : values) *value = finite(what);
}

std::int64_t LineReader::integer(std::int64_t min, std::int64_t max, std::string_view what) {
  std::int64_t value = 0;
  if (!parse(word(what), value) || value < min || value > max) fail(what);
  return value;
}

bool LineReader::at_end() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
  return rest_.empty();
}

void LineReader::end() {
  if (at_end()) return;
  last_word_ = rest_.substr(0, rest_.find_first_of(kBlank));
  fail("the end of the line");
}

}  // namespace perceptor
