// SPDX-License-Identifier: Apache-2.0
// Checkpoints: the file with its checksums; and, since those keep all that is damaged out, the state behind them.
#include "run/checkpoint.hpp"

#include "engine/simulation/simulation.hpp"
#include "output/chunk_file.hpp"
#include "run/assemble.hpp"
#include "tests/fuzz/scratch.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;

namespace {

const Model& model() {
  static const Model made = assemble(read_case_text(tests::small_die, "die.toml")).model;
  return made;
}

/// A state that is said to fit can be stepped, whatever it came from.
void step(const std::vector<std::byte>& bytes) {
  State state = load_state(bytes);
  require_fit(state, model());
  Simulation simulation(model(), std::move(state), 1);
  try {
    for (int k = 0; k < 3; ++k) simulation.step();
  } catch (const Failure& failure) {
    if (failure.code() != Exit::physics && failure.code() != Exit::internal_check) throw;
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> bytes(first, first + size);
  fuzz::may_refuse([&] { ChunkFile(bytes, "it", Checkpoint::version); });
  fuzz::may_refuse([&] { step(bytes); });
  return 0;
}
