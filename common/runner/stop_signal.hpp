/// @file SIGINT and SIGTERM ask a program to stop; it looks when it suits.
#pragma once

namespace perceptor {

/// From now on, the two signals interrupt whatever waits and set stop_requested. Writing to a
/// closed pipe, or beyond the allowed size of a file, no longer ends the process: it fails.
void catch_stop_signals();

bool stop_requested();

}  // namespace perceptor
