// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pulvis {

/// Asks the run of this process to stop after its step; signal handlers may call it. The signals are those of
/// <csignal>: SIGINT ends it with results up to then (exit 130), any other leaves it as it is, with a
/// checkpoint to go on from (exit 75).
void ask_to_stop(int signal);

/// The signal for which the run is to stop; 0: none.
int signal_to_stop();

}  // namespace pulvis
