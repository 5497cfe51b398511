// SPDX-License-Identifier: Apache-2.0
#include "run/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "output/chunk_file.hpp"
#include "output/safe_file.hpp"
#include "run/checkpoint_fields.hpp"

namespace pulvis {
namespace {

namespace fs = std::filesystem;

Checkpoint read_checkpoint(const std::string& path) {
  const ChunkFile file(path, Checkpoint::version);
  Checkpoint c;
  try {
    from_bytes(file["case"], c.program, c.time_step, c.keys);
    from_bytes(file["state"], c.state);
    from_bytes(file["run"], c.loads, c.flows, c.summary, c.times, c.results);
  } catch (const Failure& failure) {
    throw Failure(Exit::bad_input, fmt::format("{}: {}", path, failure.what()));
  }
  return c;
}

}  // namespace

Checkpoints::Checkpoints(const RunFolder& folder) : folder_(folder) {}

std::string Checkpoints::file(std::uint64_t number) const {
  return folder_.file(fmt::format("checkpoints/checkpoint-{}.pulvis", number));
}

std::vector<std::uint64_t> Checkpoints::numbers() const {
  std::vector<std::uint64_t> list;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_.file("checkpoints"), none)) {
    const std::string name = entry.path().filename().string();
    std::uint64_t number = 0;
    const auto dash = name.find('-');
    if (dash == std::string::npos) continue;
    std::from_chars(name.data() + dash + 1, name.data() + name.size(), number);
    if (number > 0 && fs::path(file(number)).filename() == name) list.push_back(number);
  }
  std::sort(list.begin(), list.end());
  return list;
}

void Checkpoints::remove(std::uint64_t number) const {
  std::error_code error;
  fs::remove(file(number), error);
  if (error) fail_to_write(file(number), error.value());
}

void Checkpoints::write(const Checkpoint& c) {
  folder_.folder("checkpoints");
  sync_folder(folder_.path());  // and with it the names of all that it knows of
  const std::vector<Chunk> chunks = {{"case", to_bytes(c.program, c.time_step, c.keys)},
                                     {"state", save_state(c.state)},
                                     {"run", to_bytes(c.loads, c.flows, c.summary, c.times, c.results)}};
  write_chunk_file(file(last_ + 1), Checkpoint::version, chunks);
  ++last_;
  for (const std::uint64_t number : numbers())
    if (number + 1 < last_ || number > last_) remove(number);
}

Checkpoint Checkpoints::newest() {
  auto list = numbers();
  if (list.empty())
    throw Failure(Exit::usage,
                  fmt::format("there is no checkpoint in {} to go on from; start the run without "
                              "--resume (with --force if there are results)",
                              folder_.path()));
  for (; !list.empty(); list.pop_back()) {
    try {
      Checkpoint checkpoint = read_checkpoint(file(list.back()));
      last_ = list.back();
      return checkpoint;
    } catch (const Failure& failure) {
      fmt::print(stderr, "warning: a checkpoint cannot be used: {}\n", failure.what());
    }
  }
  throw Failure(Exit::bad_input, fmt::format("no checkpoint in {} is intact; start the run anew with --force",
                                             folder_.path()));
}

}  // namespace pulvis
