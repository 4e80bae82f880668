#include "common/runner/runner.hpp"
#include "components/bridge/bridge_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::BridgeComponent>(argc, argv);
}
