/// Runs a target on its seeds, on what broke it once, and on changes of both, the same each time:
///   fuzz_<target> [FOLDER ...]           files of these folders are inputs as well
///   fuzz_<target> --write FOLDER         writes the seeds there, for libFuzzer
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/target.hpp"

namespace perceptor::fuzz {
namespace {

constexpr int kChanges = 3000;  // in all: seconds
constexpr std::size_t kLongest = 65'536;

Bytes read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void run(const Bytes& input) { LLVMFuzzerTestOneInput(input.data(), input.size()); }

/// One to four edits: a byte, an extreme number, a piece taken out or repeated, the end cut off.
Bytes changed(Bytes bytes, std::mt19937& random) {
  const auto below = [&](std::size_t bound) { return random() % std::max<std::size_t>(1, bound); };
  for (std::size_t edits = 1 + below(4); edits > 0 && !bytes.empty(); --edits) {
    const auto at = static_cast<std::ptrdiff_t>(below(bytes.size()));
    const auto left = bytes.size() - static_cast<std::size_t>(at);
    const auto length =
        static_cast<std::ptrdiff_t>(1 + below(std::min<std::size_t>(left, 32)) % left);
    const Bytes piece(bytes.begin() + at, bytes.begin() + at + length);
    switch (below(5)) {
      case 0:
        bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        std::fill_n(bytes.begin() + at, length,
                    below(2) == 0 ? std::uint8_t{0xFF} : std::uint8_t{0});
        break;
      case 2:
        bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
        break;
      case 3:
        if (bytes.size() < kLongest) bytes.insert(bytes.begin() + at, piece.begin(), piece.end());
        break;
      default:
        bytes.resize(static_cast<std::size_t>(at));
    }
  }
  return bytes;
}

int write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const Bytes& seed : seeds()) {
    std::ofstream out(folder / ("seed" + std::to_string(number++)), std::ios::binary);
    out.write(reinterpret_cast<const char*>(seed.data()),
              static_cast<std::streamsize>(seed.size()));
  }
  return 0;
}

int run_all(std::span<char*> folders) {
  std::vector<Bytes> inputs = seeds();
  const std::size_t good = inputs.size();
  for (const char* folder : folders)
    if (std::filesystem::is_directory(folder))
      for (const auto& file : std::filesystem::directory_iterator(folder))
        inputs.push_back(read(file.path()));
  for (const Bytes& input : inputs) run(input);
  std::mt19937 random(1);
  for (int i = 0; i < kChanges; ++i) run(changed(inputs[random() % inputs.size()], random));
  std::printf("%zu seeds, %zu other inputs, %d changes of them\n", good, inputs.size() - good,
              kChanges);
  return 0;
}

}  // namespace
}  // namespace perceptor::fuzz

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv + 1, static_cast<std::size_t>(argc - 1));
  if (arguments.size() == 2 && std::string(arguments[0]) == "--write")
    return perceptor::fuzz::write_seeds(arguments[1]);
  return perceptor::fuzz::run_all(arguments);
}
