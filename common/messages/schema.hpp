/// @file The check of raw bytes, from the schema that lcm-gen itself emits: no parser is
/// written by hand. It has to pass before the generated decode runs, which trusts lengths.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <lcm/lcm_coretypes.h>
#include <pico/all_types.h>

#include "common/time/stamp.hpp"

namespace pico {
#define PICO_TYPE(type) class type;  // NOLINT(bugprone-macro-parentheses): a name
#include <pico/all_types.inc>
#undef PICO_TYPE
}  // namespace pico

namespace perceptor::messages {

/// The type information of each C++ message class.
template <class Message>
const lcm_type_info_t* type_info();

// Kept in a static, because the generated function fills its table anew at each call.
#define PICO_TYPE(type)                                                       \
  template <>                                                                 \
  inline const lcm_type_info_t* type_info<pico::type>() {                     \
    static const lcm_type_info_t* const info = pico_##type##_get_type_info(); \
    return info;                                                              \
  }
#include <pico/all_types.inc>
#undef PICO_TYPE

/// What is wrong with the bytes as a message of this type, as a fixed text; empty: nothing.
/// Checked are the fingerprint, each array's length (not negative, and not more than bytes
/// are left), each string (terminated, no zero inside), each boolean (0 or 1), and that
/// nothing is left over. Allocates nothing, and takes time in proportion to the bytes. What
/// passes is decoded without error, into memory in proportion to the bytes.
std::string_view find_fault(const lcm_type_info_t* type, std::span<const std::uint8_t> bytes);

template <class Message>
std::string_view find_fault(std::span<const std::uint8_t> bytes) {
  return find_fault(type_info<Message>(), bytes);
}

/// The stamp that every data message of ours begins with, after the fingerprint; of a STATUS:
/// utime, boot and seq. None where there are not enough bytes.
std::optional<Stamp> stamp_in(std::span<const std::uint8_t> bytes);

}  // namespace perceptor::messages
