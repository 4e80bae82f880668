#include "components/record/recording.hpp"

#include <utility>

namespace perceptor::record {

Recording::Recording(const std::filesystem::path& file, LogWriter::Mode mode)
    : file_(file), writer_(std::in_place, file, mode), size_(writer_->size()) {}

void Recording::add(std::string_view channel, std::int64_t received_at,
                    std::span<const std::uint8_t> payload) {
  if (!writer_) {
    ++lost_;
    return;
  }
  try {
    writer_->write(channel, received_at, payload.data(), payload.size());
  } catch (const LogError& error) {
    ++lost_;
    stop(error);
  }
}

void Recording::flush() {
  try {
    if (!writer_) writer_.emplace(file_, LogWriter::Mode::append);
    writer_->flush();
    size_ = writer_->size();
    if (writer_->written() > 0) trouble_.clear();  // that it could be opened proves nothing
  } catch (const LogError& error) {
    stop(error);
  }
}

std::int64_t Recording::take_lost() { return std::exchange(lost_, 0); }

void Recording::stop(const LogError& error) {
  trouble_ = error.what();
  if (!writer_) return;
  lost_ += writer_->give_up();
  writer_.reset();
}

}  // namespace perceptor::record
