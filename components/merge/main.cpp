#include "common/runner/runner.hpp"
#include "components/merge/merge_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::MergeComponent>(argc, argv);
}
