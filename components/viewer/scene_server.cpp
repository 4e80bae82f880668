#include "components/viewer/scene_server.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include <httplib.h>
#include <sys/socket.h>

#include "common/bus/own_sockets.hpp"

namespace perceptor::viewer {
namespace {

constexpr int kPageThreads = 4;         // answer for the page's files beside those who look
constexpr int kRead_s = 2;              // a client that sends nothing for so long is cut off
constexpr int kWrite_s = 2;             // and one that takes nothing
constexpr int kSendBuffer = 64 * 1024;  // [bytes] of scenes that a slow client is behind
constexpr std::chrono::milliseconds kBeat{1000};  // a client that went away is noticed by then
constexpr int kNotAllowed = 405;                  // "Method Not Allowed"
constexpr int kBusy = 503;                        // "Service Unavailable"

/// The newest parts, each with the number of the scene that brought its change.
class Board {
 public:
  void publish(const JsonParts& parts) {
    {
      const std::lock_guard lock(mutex_);
      ++newest_;
      for (const auto& [name, text] : parts) {
        Part& part = parts_[name];
        if (part.since == 0 || part.text != text) part = {text, newest_};
      }
    }
    changed_.notify_all();
  }

  /// What changed since scene `seen`, which becomes the newest: as JSON; empty where nothing did
  /// for a while, or the board is closed.
  std::string changes(std::uint64_t& seen) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kBeat, [&] { return newest_ > seen || closed_; });
    std::string json;
    for (const auto& [name, part] : parts_)
      if (part.since > seen)
        json.append(json.empty() ? "{\"" : ",\"").append(name).append("\":").append(part.text);
    seen = newest_;
    return json.empty() ? json : json + "}";
  }

  void forget() {
    const std::lock_guard lock(mutex_);
    parts_.clear();
  }

  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  bool is_closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
  }

 private:
  struct Part {
    std::string text;
    std::uint64_t since = 0;
  };
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Part> parts_;
  std::uint64_t newest_ = 0;
  bool closed_ = false;
};

const char* mime_type(std::string_view path) {
  if (path.ends_with(".html")) return "text/html; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "application/json";
}

/// The library's own choice lets a second server take the same port in silence. The connections
/// take over the size of the buffer.
void prepare(int listening_socket) {
  const int yes = 1;
  setsockopt(listening_socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  setsockopt(listening_socket, SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof(kSendBuffer));
}

/// Ends whatever the library still reads or writes, for which it would wait as long as somebody
/// sends a byte now and then. It does not hand out its connections.
void cut_connections(int port) {
  for (const int connection : own_sockets(SOCK_STREAM, static_cast<std::uint16_t>(port)))
    shutdown(connection, SHUT_RDWR);
}

}  // namespace

class SceneServer::Impl {
 public:
  Impl(const ServerParameters& parameters, std::vector<PageFile> files)
      : parameters_(parameters), files_(std::move(files)) {
    server_.new_task_queue = [threads = parameters.clients + kPageThreads] {
      return new httplib::ThreadPool(static_cast<std::size_t>(threads));
    };
    server_.set_socket_options(prepare);
    server_.set_keep_alive_timeout(kRead_s);
    server_.set_read_timeout(kRead_s);
    server_.set_write_timeout(kWrite_s);
    server_.set_default_headers({{"Content-Security-Policy", "default-src 'self'"},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Cache-Control", "no-store"}});
    server_.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& reply) {
      if (request.method == "GET") return httplib::Server::HandlerResponse::Unhandled;
      reply.status = kNotAllowed;
      reply.set_header("Allow", "GET");
      return httplib::Server::HandlerResponse::Handled;
    });
    for (const PageFile& file : files_) {
      const auto answer = [&file](const httplib::Request&, httplib::Response& reply) {
        reply.set_content(file.content, mime_type(file.path));
      };
      server_.Get(file.path, answer);
      if (file.path == "/index.html") server_.Get("/", answer);
    }
    server_.Get("/scenes",
                [this](const httplib::Request&, httplib::Response& reply) { show_scenes(reply); });
    if (!server_.bind_to_port(parameters.address, parameters.port))
      throw std::runtime_error("cannot listen on " + parameters.address + ":" +
                               std::to_string(parameters.port) +
                               ": is another viewer running there? --port chooses another port");
    listening_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  ~Impl() {
    board_.close();
    server_.stop();
    cut_connections(parameters_.port);
    listening_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void publish(const JsonParts& parts) { board_.publish(parts); }
  void forget() { board_.forget(); }
  int clients() const { return clients_; }

 private:
  void show_scenes(httplib::Response& reply) {
    if (++clients_ > parameters_.clients) {
      --clients_;
      reply.status = kBusy;
      return reply.set_content("as many look as may: " + std::to_string(parameters_.clients),
                               "text/plain");
    }
    reply.set_chunked_content_provider(
        "text/event-stream",
        [this, seen = std::uint64_t{0}](std::size_t, httplib::DataSink& sink) mutable {
          const std::string changes = board_.changes(seen);
          if (board_.is_closed()) return false;
          const std::string event = changes.empty() ? ":\n\n" : "data: " + changes + "\n\n";
          return sink.write(event.data(), event.size());
        },
        [this](bool) { --clients_; });
  }

  ServerParameters parameters_;
  std::vector<PageFile> files_;
  Board board_;
  std::atomic<int> clients_ = 0;
  httplib::Server server_;
  std::thread listening_;
};

SceneServer::SceneServer(const ServerParameters& parameters, std::vector<PageFile> files)
    : impl_(std::make_unique<Impl>(parameters, std::move(files))) {}
SceneServer::~SceneServer() = default;

void SceneServer::publish(const JsonParts& parts) { impl_->publish(parts); }
void SceneServer::forget() { impl_->forget(); }
int SceneServer::clients() const { return impl_->clients(); }

}  // namespace perceptor::viewer
