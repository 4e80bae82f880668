#include "common/runner/runner.hpp"
#include "components/identify/identify_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::IdentifyComponent>(argc, argv);
}
