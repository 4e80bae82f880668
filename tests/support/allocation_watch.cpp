#include "tests/support/allocation_watch.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

std::size_t count = 0;
std::size_t largest = 0;

}  // namespace

namespace perceptor::test {

void forget_allocations() {
  count = 0;
  largest = 0;
}
std::size_t allocations() { return count; }
std::size_t largest_allocation() { return largest; }

}  // namespace perceptor::test

void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++count;
  largest = std::max(largest, size);
  return std::malloc(std::max<std::size_t>(size, 1));
}

void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
