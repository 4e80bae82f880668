#include "tools/vectorize/read_grid.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "common/config/fields.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

class ReadGrid : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  /// Two rows of three: the upper one black, grey, white.
  std::filesystem::path image() {
    return write("map.pgm",
                 std::string("P5\n3 2\n255\n") + '\x00' + '\xcd' + '\xfe' + "\xfe\xfe\xfe");
  }

  TemporaryFolder folder_;
};

TEST_F(ReadGrid, FirstRowOfTheImageIsTheHighest) {
  const OccupancyGrid grid = read_image(image(), {});
  ASSERT_EQ(grid.width, 3);
  ASSERT_EQ(grid.height, 2);
  EXPECT_EQ(grid.at(0, 1), CellState::occupied);
  EXPECT_EQ(grid.at(1, 1), CellState::unknown);
  EXPECT_EQ(grid.at(2, 1), CellState::free);
  EXPECT_EQ(grid.at(0, 0), CellState::free);
  EXPECT_EQ(grid.at(3, 0), CellState::unknown);
}

TEST_F(ReadGrid, MapServerSaysHowItIsMeant) {
  image();
  const OccupancyGrid grid =
      read_map_server(write("map.yaml",
                            "image: map.pgm\nresolution: 0.1\norigin: [1.0, -2.0, 0.5]\nnegate: 1\n"
                            "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  EXPECT_DOUBLE_EQ(grid.resolution, 0.1);
  EXPECT_EQ(grid.grid_in_world, (Position{1.0, -2.0, 0.5}));
  EXPECT_EQ(grid.at(0, 1), CellState::free);
  EXPECT_EQ(grid.at(2, 1), CellState::occupied);
}

TEST_F(ReadGrid, ErrorsNameTheFile) {
  const auto expect_error = [](const auto& read, const std::string& what) {
    try {
      read();
      ADD_FAILURE() << "no error: " << what;
    } catch (const config::Error& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  expect_error([&] { read_image(write("no.png", "not an image"), {}); }, "no.png");
  expect_error([&] { read_map_server(folder_.path() / "nothing.yaml"); }, "nothing.yaml");
  expect_error([&] { read_map_server(write("a.yaml", "a: [1, 2")); }, "a.yaml");
  expect_error([&] { read_map_server(write("b.yaml", "resolution: 0.1\n")); }, "b.yaml");
  expect_error([&] { read_map_server(write("c.yaml", "image: gone.pgm\nresolution: 0.1\n")); },
               "gone.pgm");
  expect_error([&] { read_map_server(write("d.yaml", "image: map.pgm\nresolution: -1\n")); },
               "resolution");
  expect_error([&] { read_map_server(write("e.yaml", "image: map.pgm\nresolution: wide\n")); },
               "e.yaml");
}

}  // namespace
}  // namespace perceptor
