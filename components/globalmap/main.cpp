#include "common/runner/runner.hpp"
#include "components/globalmap/globalmap_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::GlobalmapComponent>(argc, argv);
}
