/// @file The check of raw bytes, from the schema that lcm-gen itself emits: no parser is
/// written by hand. It has to pass before the generated decode runs, which trusts lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <lcm/lcm_coretypes.h>

#include <pico/all_types.h>

namespace perceptor::messages {

/// The type information of each C++ message class.
template <class Message>
const lcm_type_info_t* type_info();

/// What is wrong with the bytes as a message of this type; empty: nothing. Checked are the
/// fingerprint, each array's length (not negative, and not more than bytes are left), each
/// string (terminated, no zero inside), each boolean (0 or 1), and that nothing is left over.
std::string_view find_fault(const lcm_type_info_t* type, std::span<const std::uint8_t> bytes);

template <class Message>
std::string_view find_fault(std::span<const std::uint8_t> bytes) {
  return find_fault(type_info<Message>(), bytes);
}

}  // namespace perceptor::messages
