#include "common/runner/runner.hpp"
#include "components/locate/locate_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::LocateComponent>(argc, argv);
}
