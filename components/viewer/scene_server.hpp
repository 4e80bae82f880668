/// @file Serves a page and the newest scene to browsers, over HTTP and server-sent events (WHATWG,
/// "HTML Living Standard", 9.2). It knows nothing of what is in a scene.
///
/// A client gets the parts that changed since the last that it took. One that is slow skips what
/// came in between: nothing is kept for it but what its socket holds, and nobody waits for it. The
/// library reads as long a request as somebody sends, so it is for those whom one trusts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/viewer/scene_json.hpp"

namespace perceptor::viewer {

struct ServerParameters {
  std::string address = "127.0.0.1";  ///< to listen on; 0.0.0.0: on every network
  int port = 8080;
  int clients = 10;  ///< that may look at a time; one more is told so
};

/// A file of the page.
struct PageFile {
  std::string path;  ///< as the browser asks for it: "/page.css"; "/" gives "/index.html"
  std::string content;
};

class SceneServer {
 public:
  /// Listens from now on. Answers GET only. Throws std::runtime_error where it cannot listen.
  SceneServer(const ServerParameters& parameters, std::vector<PageFile> files);
  /// Cuts off whoever is still connected.
  ~SceneServer();
  SceneServer(const SceneServer&) = delete;
  SceneServer& operator=(const SceneServer&) = delete;

  /// Replaces these parts of the scene. Never waits for a client.
  void publish(const JsonParts& parts);

  /// Nothing is known any more: who comes next sees nothing old.
  void forget();

  /// Who looks.
  int clients() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace perceptor::viewer
