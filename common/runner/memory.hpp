/// @file How the process deals with memory that it no longer needs.
#pragma once

#include <malloc.h>

namespace perceptor {

/// Keeps freed memory for the next message. Otherwise the C library gives what one scan took
/// back to the system and asks for it again with the next, a page fault for each page.
inline void keep_freed_memory() {
  constexpr int kMostKept = 4 * 1024 * 1024;  // [bytes] a scan takes less than a quarter of it
  mallopt(M_TRIM_THRESHOLD, kMostKept);
}

}  // namespace perceptor
