#include "tools/progress.hpp"

#include <cstdio>
#include <utility>

#include <unistd.h>

namespace perceptor {
namespace {

constexpr int kWidth = 40;         // characters of the bar
constexpr int kCallsPerLook = 64;  // looking at the clock costs more than the work between

}  // namespace

Progress::Progress(std::string what, std::int64_t total)
    : what_(std::move(what)),
      total_(total),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      started_(std::chrono::steady_clock::now()),
      last_drawn_(started_) {}

Progress::~Progress() {
  if (drawn_) std::fputc('\n', stderr);
}

void Progress::at(std::int64_t done) {
  if (!on_terminal_ || total_ <= 0 || ++calls_ % kCallsPerLook != 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_drawn_ < std::chrono::milliseconds(100)) return;
  last_drawn_ = now;
  drawn_ = true;

  const double share = static_cast<double>(done) / static_cast<double>(total_);
  const std::chrono::duration<double> spent = now - started_;
  const double left = share > 0.0 ? spent.count() * (1.0 - share) / share : 0.0;
  const auto filled = static_cast<int>(share * kWidth);
  std::string bar(static_cast<std::size_t>(filled), '#');
  bar.resize(kWidth, '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%, %.0f s left ", what_.c_str(), bar.c_str(),
               100.0 * share, left);
}

}  // namespace perceptor
