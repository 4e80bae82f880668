/// A map file of the Hospital Challenge, read and made into a global map.
#include "common/config/place.hpp"
#include "common/global_map/global_map.hpp"
#include "tests/fuzz/target.hpp"

namespace perceptor::fuzz {

std::vector<Bytes> seeds() {
  const std::string points =
      R"("points": [{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 3.5}, {"x": 0, "y": 3}, )"
      R"({"x": 1, "y": 1}, {"x": 1.5, "y": 1}, {"x": 1.5, "y": 1.4}, {"x": 1, "y": 1.4}])";
  const std::string walls = R"("walls": [[0, 1], [1, 2], [2, 3], [3, 0]])";
  const std::string cabinets = R"("cabinets": [[[4, 5], [5, 6], [6, 7], [7, 4]]])";
  return {bytes_of("{" + points + ", " + walls + ", " + cabinets + "}"),
          bytes_of("{" + points + ", " + walls + R"(, "doors": [[[0, 1]]], "start_area": )" +
                   R"([[[4, 5], [5, 6], [6, 7], [7, 4]]], "cabinets": [], "more": 1})")};
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace perceptor;
  const fuzz::MemoryFile file({data, size});
  try {
    const global_map::GlobalMap global = global_map::make_global_map(read_floorplan(file.path()));
    fuzz::require(find_broken_reference(global.map).empty(),
                  "a global map has no broken reference");
  } catch (const config::Error&) {
    return 0;  // with a reason
  } catch (const global_map::TooManyCrossings&) {
    return 0;
  }
  return 0;
}
