#include "common/runner/runner.hpp"
#include "components/localize/localize_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::LocalizeComponent>(argc, argv);
}
