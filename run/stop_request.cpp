// SPDX-License-Identifier: Apache-2.0
#include "run/stop_request.hpp"

#include <atomic>

namespace pulvis {
namespace {

std::atomic<int> asked{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");

}  // namespace

void ask_to_stop(int signal) { asked = signal; }

int signal_to_stop() { return asked; }

}  // namespace pulvis
