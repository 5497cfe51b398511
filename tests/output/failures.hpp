// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>

#include "engine/base/failure.hpp"
#include "output/file_calls.hpp"

namespace pulvis::test {

/// Expects `action` to fail with `code`; returns the message.
template <class Action>
std::string failure_of(Exit code, const Action& action) {
  try {
    action();
  } catch (const Failure& failure) {
    EXPECT_EQ(static_cast<int>(failure.code()), static_cast<int>(code)) << failure.what();
    return failure.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

/// A disk with room for `free_bytes` more.
class SmallDisk {
 public:
  static FileCalls calls(std::size_t free_bytes) {
    free_ = free_bytes;
    FileCalls calls = FileCalls::system();
    calls.write = [](int file, const void* data, std::size_t size) -> ssize_t {
      if (free_ == 0) {
        errno = ENOSPC;
        return -1;
      }
      const std::size_t part = std::min(size, free_);  // the kernel too writes what still fits
      free_ -= part;
      return FileCalls::system().write(file, data, part);
    };
    return calls;
  }

 private:
  static inline std::size_t free_ = 0;
};

}  // namespace pulvis::test
