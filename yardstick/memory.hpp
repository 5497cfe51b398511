// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pulvis::yardstick {

/// Bytes this process may still take without pressing others out of memory; infinite where the system does not say.
double free_memory();
/// The most bytes this process had so far.
double peak_memory();

}  // namespace pulvis::yardstick
