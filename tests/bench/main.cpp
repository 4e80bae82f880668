#include <benchmark/benchmark.h>

#include "common/runner/memory.hpp"

int main(int argc, char** argv) {
  perceptor::keep_freed_memory();  // as every process does
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
