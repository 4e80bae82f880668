#include "components/bridge/ros/master_probe.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <thread>
#include <utility>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace perceptor {
namespace {

using Answer = MasterProbe::Answer;

/// A question of which a master answers to anybody: its process id.
std::string question_for(const MasterAddress& master, const std::string& node) {
  const std::string body =
      "<?xml version=\"1.0\"?><methodCall><methodName>getPid</methodName><params><param><value>"
      "<string>/" +
      node + "</string></value></param></params></methodCall>";
  return "POST /RPC2 HTTP/1.0\r\nHost: " + master.host + "\r\nContent-Type: text/xml\r\n" +
         "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

/// "HTTP/1.x 200": it understood.
constexpr std::size_t kStatusLine = 12;
bool is_success(std::string_view reply) {
  return reply.starts_with("HTTP/1.") && reply.substr(8, 4) == " 200";
}

/// The address of a host, looked up by a thread of its own. It cannot be called off: whoever no
/// longer wants to know leaves it behind.
class Lookup {
 public:
  explicit Lookup(const MasterAddress& master) : found_(std::make_shared<Found>()) {
    std::thread([master, found = found_] {
      addrinfo hints{};
      hints.ai_family = AF_INET;  // as roscpp, unless told otherwise
      hints.ai_socktype = SOCK_STREAM;
      addrinfo* addresses = nullptr;
      if (getaddrinfo(master.host.c_str(), master.port.c_str(), &hints, &addresses) == 0)
        found->addresses.reset(addresses);
      found->is_done = true;
    }).detach();
  }

  Answer answer() const {
    if (!found_->is_done) return Answer::not_yet;
    return result() != nullptr ? Answer::yes : Answer::no;
  }
  const addrinfo* result() const { return found_->addresses.get(); }

 private:
  struct Found {
    std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses{nullptr, &freeaddrinfo};
    std::atomic<bool> is_done = false;
  };
  std::shared_ptr<Found> found_;
};

/// A connection that never waits.
class Connection {
 public:
  explicit Connection(const addrinfo& to)
      : socket_(socket(to.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)),
        is_open_(connect(socket_, to.ai_addr, to.ai_addrlen) == 0 || errno == EINPROGRESS) {}
  ~Connection() {
    if (socket_ >= 0) close(socket_);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool is_open() const { return is_open_; }

  /// Sends some of what is left of `text`, and takes that off it.
  void send_some(std::string_view& text) {
    if (!is_ready(POLLOUT)) return;
    const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
    if (went_on(sent)) text.remove_prefix(static_cast<std::size_t>(sent));
  }

  /// Appends to `text` what has come.
  void receive_some(std::string& text) {
    if (!is_ready(POLLIN)) return;
    std::array<char, 256> block{};
    const ssize_t got = recv(socket_, block.data(), block.size(), 0);
    if (went_on(got)) text.append(block.data(), static_cast<std::size_t>(got));
    if (got == 0) is_open_ = false;
  }

 private:
  bool is_ready(short event) const {
    pollfd descriptor{socket_, event, 0};
    return poll(&descriptor, 1, 0) > 0;
  }

  /// Errors close it, but for those that only mean "later".
  bool went_on(ssize_t bytes) {
    const bool is_later = bytes < 0 && (errno == EAGAIN || errno == EINTR);
    if (bytes < 0 && !is_later) is_open_ = false;
    return bytes >= 0;
  }

  int socket_;
  bool is_open_;
};

}  // namespace

std::optional<MasterAddress> parse_master_uri(std::string_view uri) {
  constexpr std::string_view scheme = "http://";
  if (!uri.starts_with(scheme)) return std::nullopt;
  uri.remove_prefix(scheme.size());
  if (uri.ends_with('/')) uri.remove_suffix(1);
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  const std::string_view port = uri.substr(colon + 1);
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(port.begin(), port.end(), number);
  const bool is_port = error == std::errc{} && end == port.end() && number > 0;
  if (!is_port) return std::nullopt;
  return MasterAddress{std::string(uri.substr(0, colon)), std::string(port)};
}

/// Looks the host up, connects, asks, and reads the first words of the reply.
class MasterProbe::Question {
 public:
  Question(const MasterAddress& master, const std::string& node)
      : lookup_(master), text_(question_for(master, node)), unsent_(text_) {}

  Answer answer() {
    if (!connection_) {
      const Answer found = lookup_.answer();
      if (found != Answer::yes) return found;
      connection_.emplace(*lookup_.result());
    }
    if (connection_->is_open() && !unsent_.empty()) connection_->send_some(unsent_);
    if (connection_->is_open() && unsent_.empty()) connection_->receive_some(reply_);
    if (reply_.size() >= kStatusLine) return is_success(reply_) ? Answer::yes : Answer::no;
    return connection_->is_open() ? Answer::not_yet : Answer::no;
  }

 private:
  Lookup lookup_;
  std::optional<Connection> connection_;
  std::string text_;
  std::string_view unsent_;
  std::string reply_;
};

MasterProbe::MasterProbe(MasterAddress address, std::string node)
    : address_(std::move(address)), node_(std::move(node)) {}

MasterProbe::~MasterProbe() = default;

Answer MasterProbe::ask(std::int64_t now) {
  if (!question_) {
    question_ = std::make_unique<Question>(address_, node_);
    give_up_ = now + kPatience;
  }
  Answer answer = question_->answer();
  if (answer == Answer::not_yet && now >= give_up_) answer = Answer::no;
  if (answer != Answer::not_yet) question_.reset();
  return answer;
}

}  // namespace perceptor
