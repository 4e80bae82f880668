#include "common/runner/runner.hpp"
#include "components/viewer/viewer_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::ViewerComponent>(argc, argv);
}
