// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/base/failure.hpp"

namespace pulvis::fuzz {

/// A folder of this process, gone at its end; in memory where the system has such a place.
class Scratch {
 public:
  Scratch() {
    const char* root = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
    path_ = std::string(root) + "/pulvis-fuzz-" + std::to_string(::getpid());
    std::filesystem::create_directories(path_);
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(file(name)).parent_path());
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

 private:
  std::string path_;
};

/// Runs what may refuse its input, but only so: anything else that it throws is a finding. The same for a refusal with
/// another exit code than those two.
template <class Read>
void may_refuse(Read&& read) {
  try {
    read();
  } catch (const Failure& failure) {
    const bool fits = failure.code() == Exit::bad_case || failure.code() == Exit::bad_input;
    if (fits && std::string(failure.what()).size() > 1) return;
    std::fprintf(stderr, "exit %d: %s\n", static_cast<int>(failure.code()), failure.what());
    std::abort();
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace pulvis::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
