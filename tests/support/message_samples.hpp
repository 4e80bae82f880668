/// @file One good message of each type, with something in every array, and its bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "common/messages/validate.hpp"

namespace perceptor::messages {

using Bytes = std::vector<std::uint8_t>;

template <class Message>
Bytes encoded(const Message& message) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

template <class Message>
Message sample();

/// Everything that carries a stamp.
template <class Message>
Message stamped() {
  Message message{};
  message.utime = 1'500'000;
  message.session = 42;
  message.seq = 7;
  return message;
}

}  // namespace perceptor::messages
