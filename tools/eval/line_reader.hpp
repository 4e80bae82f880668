/// @file A text file of words and numbers, plain or gzipped, read line by line. What is wrong
/// with it is told with the file, the line, what was expected and what stands there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct gzFile_s;

namespace perceptor {

/// The file cannot be read, or does not hold what it should.
class TextFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class LineReader {
 public:
  /// Throws TextFileError where the file cannot be opened.
  explicit LineReader(const std::filesystem::path& file);

  /// Goes to the next line that holds something and is no comment (#); false at the end.
  /// Throws TextFileError where the file cannot be read on or a line is longer than any of a
  /// real file.
  bool next();

  std::string_view line() const { return line_; }  ///< the whole line, until next()

  // The next word of the line, as what `what` says it should be. Throw TextFileError where it
  // is something else, or missing.
  std::string_view word(std::string_view what);
  double number(std::string_view what);  ///< "nan" and "inf" included
  double finite(std::string_view what);
  void finite(std::initializer_list<double*> values, std::string_view what);
  std::int64_t integer(std::int64_t min, std::int64_t max, std::string_view what);

  /// Whether nothing is left on the line.
  bool at_end();

  /// Throws TextFileError where more is left on the line.
  void end();

  /// Throws TextFileError about the word that was read last.
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  struct Close {
    void operator()(gzFile_s* file) const;
  };

  /// Whether there is one more.
  bool read_line();
  bool refill();

  std::string name_;
  std::unique_ptr<gzFile_s, Close> file_;
  std::vector<char> block_;
  std::size_t block_begin_ = 0;
  std::size_t block_end_ = 0;

  std::string line_;
  std::int64_t line_number_ = 0;
  std::string_view rest_;       // of line_
  std::string_view last_word_;  // of line_; empty: the line ended
};

}  // namespace perceptor
