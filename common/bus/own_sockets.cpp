#include "common/bus/own_sockets.hpp"

#include <cstdlib>
#include <filesystem>

#include <netinet/in.h>
#include <sys/socket.h>

namespace perceptor {
namespace {

bool is_socket_on(int descriptor, int wanted_type, std::uint16_t port) {
  int type = 0;
  socklen_t size = sizeof(type);
  if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != wanted_type)
    return false;
  sockaddr_in address{};
  size = sizeof(address);
  return getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
         address.sin_family == AF_INET && ntohs(address.sin_port) == port;
}

}  // namespace

std::vector<int> own_sockets(int type, std::uint16_t port) {
  std::vector<int> sockets;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    if (is_socket_on(descriptor, type, port)) sockets.push_back(descriptor);
  }
  return sockets;
}

}  // namespace perceptor
