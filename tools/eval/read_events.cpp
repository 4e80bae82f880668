#include "tools/eval/read_events.hpp"

#include <cstdio>

#include "tools/progress.hpp"

namespace perceptor {

void read_events(const std::filesystem::path& log,
                 const std::function<void(const LogEvent&)>& take) {
  LogReader reader(log);
  {
    Progress progress("reading", reader.size());
    LogEvent event;
    while (reader.next(event)) {
      take(event);
      progress.at(reader.offset());
    }
  }
  for (const LogDamage& damage : reader.damage())
    std::fprintf(stderr, "pico-eval: %lld damaged bytes passed over at byte %lld\n",
                 static_cast<long long>(damage.size), static_cast<long long>(damage.offset));
}

}  // namespace perceptor
