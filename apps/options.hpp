// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <csignal>

#include "run/stop_request.hpp"

namespace pulvis {

/// The value of an option, or an empty one if it was not given.
template <typename Value>
Value value_of(const CLI::App& command, const char* option) {
  return command.count(option) > 0 ? command.get_option(option)->as<Value>() : Value{};
}

extern "C" inline void on_request_to_stop(int signal) { ask_to_stop(signal); }

/// What batch systems send lets work stop where it can be gone on with.
inline void stop_on_batch_signals() {
  for (const int signal : {SIGTERM, SIGUSR1}) std::signal(signal, on_request_to_stop);
}

}  // namespace pulvis
