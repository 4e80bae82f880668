/// @file The sockets of this process that a library keeps to itself.
#pragma once

#include <cstdint>
#include <vector>

namespace perceptor {

/// Descriptors of the IPv4 sockets of this process that are bound to a port. `type`: SOCK_DGRAM, or
/// SOCK_STREAM. They belong to whoever opened them.
std::vector<int> own_sockets(int type, std::uint16_t port);

}  // namespace perceptor
