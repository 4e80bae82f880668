/// @file Messages as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace perceptor::messages {

template <class Message>
std::vector<std::uint8_t> encode(const Message& message) {
  std::vector<std::uint8_t> payload(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(payload.data(), 0, static_cast<int>(payload.size()));
  return payload;
}

}  // namespace perceptor::messages
