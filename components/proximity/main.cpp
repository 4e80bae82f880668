#include "common/runner/runner.hpp"
#include "components/proximity/proximity_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::ProximityComponent>(argc, argv);
}
