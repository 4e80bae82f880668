#include "common/runner/runner.hpp"
#include "components/record/record_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::RecordComponent>(argc, argv);
}
