#include "common/runner/runner.hpp"
#include "components/scan/scan_component.hpp"

int main(int argc, char** argv) {
  return perceptor::run_component<perceptor::ScanComponent>(argc, argv);
}
