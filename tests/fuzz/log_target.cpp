/// An LCM log: each byte is in an event or counted as damage.
#include <cstring>

#include "common/log/event_log.hpp"
#include "tests/fuzz/target.hpp"

namespace perceptor::fuzz {
namespace {

constexpr std::size_t kHead = 28;  // [bytes] of an event before its channel

}  // namespace

std::vector<Bytes> seeds() {
  const MemoryFile file;
  {
    LogWriter log(file.path());
    for (int i = 0; i < 5; ++i) log.write("PICO_LASER", 1000 * i, "some bytes of it", 16);
    log.close();
  }
  Bytes content(5 * (kHead + std::strlen("PICO_LASER") + 16));
  std::FILE* in = std::fopen(file.path().c_str(), "rb");
  require(in != nullptr && std::fread(content.data(), 1, content.size(), in) == content.size(),
          "the log was written");
  std::fclose(in);
  return {content};
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace perceptor;
  const fuzz::MemoryFile file({data, size});
  LogReader log(file.path());
  std::size_t accounted = 0;
  for (LogEvent event; log.next(event);)
    accounted += fuzz::kHead + event.channel.size() + event.data.size();
  for (const LogDamage& damage : log.damage()) accounted += static_cast<std::size_t>(damage.size);
  fuzz::require(accounted == size, "each byte is in an event or counted as damage");
  return 0;
}
