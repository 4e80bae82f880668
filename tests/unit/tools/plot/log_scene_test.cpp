#include "tools/plot/log_scene.hpp"

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/log/event_log.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/encode.hpp"
#include "common/time/stamp.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using viewer::Layer;

/// A map a second, each with one wall more.
void write_log(const std::filesystem::path& file) {
  LogWriter log(file);
  Map map;
  for (int i = 0; i < 5; ++i) {
    add_segment(map, {{0.0, 1.0 * i}, {1.0, 1.0 * i}}, ObjectType::wall);
    pico::map_t message = make_map_message("robot", map);
    set_stamp(message, {(i + 1) * kMicrosecondsPerSecond, 1, i});
    const auto bytes = messages::encode(message);
    const std::int64_t received = 100 + i;  // five seconds of a robot, simulated at once
    log.write(channel::local_map, received, bytes.data(), bytes.size());
    log.write(channel::local_map, received, "bad", 3);
    log.write("SOMEBODY_ELSES", received, "?", 1);
  }
  log.close();
}

TEST(LogScene, ShowsTheMomentThatIsAskedFor) {
  const TemporaryFolder folder;
  const auto file = folder / "five.lcmlog";
  write_log(file);
  EXPECT_EQ(scene_of_log(file, 0.0).scene[Layer::local_map].items.size(), 1U);
  const LogScene found = scene_of_log(file, 2.5);
  EXPECT_EQ(found.scene[Layer::local_map].items.size(), 3U);
  EXPECT_DOUBLE_EQ(found.seconds, 2.0);
  EXPECT_EQ(found.rejected, 3);
  EXPECT_EQ(scene_of_log(file).scene[Layer::local_map].items.size(), 5U);
}

TEST(LogScene, AnEmptyLogIsAnError) {
  const TemporaryFolder folder;
  const auto file = folder / "empty.lcmlog";
  LogWriter(file).close();
  EXPECT_THROW(scene_of_log(file), LogError);
}

}  // namespace
}  // namespace perceptor
