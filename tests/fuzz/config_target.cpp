/// A configuration file, read as pico-localize reads its own.
#include "common/config/fields.hpp"
#include "components/localize/localize_component.hpp"
#include "tests/fuzz/target.hpp"

namespace perceptor::fuzz {

std::vector<Bytes> seeds() {
  LocalizeConfig config;
  const auto described = [&config](config::Fields& fields) { describe(fields, config); };
  return {bytes_of(config::print(described)), bytes_of("{}"),
          bytes_of(R"({"map": "a b", "start": {"from": "pose", "pose": {"x": -1e-3, "a": 3}}})")};
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace perceptor;
  const fuzz::MemoryFile file({data, size});
  LocalizeConfig config;
  try {
    config::load_file(file.path(), [&config](config::Fields& fields) { describe(fields, config); });
  } catch (const config::Error&) {
    return 0;  // with a reason
  }
  config::print([&config](config::Fields& fields) { describe(fields, config); });
  return 0;
}
