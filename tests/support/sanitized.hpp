/// @file Whether a sanitizer watches.
#pragma once

namespace perceptor::test {

/// Then most of a process's memory is the sanitizer's own, and its size tells nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace perceptor::test
