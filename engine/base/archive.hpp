// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/base/failure.hpp"

// Things to bytes and back. A type names its fields once,
//     template <class Archive> void fields(Archive& archive, Thing& thing) { archive(thing.a, thing.b); }
// and both directions go through that list, so that neither can forget what the other knows. Fields are packed
// without gaps, numbers little-endian; a list is its length in 8 bytes and its elements, text the same, a bool
// one byte, something optional a bool and what it holds. Equal things give equal bytes.
namespace pulvis {

static_assert(std::endian::native == std::endian::little, "saved bytes are those of memory");

/// Appends things to bytes.
class ByteWriter {
 public:
  static constexpr bool reading = false;

  template <class... T>
  void operator()(const T&... things) {
    (put(things), ...);
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  template <class T>
  void put(const T& thing) {
    if constexpr (std::is_same_v<T, bool>) {
      put(static_cast<std::uint8_t>(thing));
    } else if constexpr (std::is_arithmetic_v<T>) {
      put_raw(&thing, sizeof thing);
    } else {
      fields(*this, const_cast<T&>(thing));  // names them only: nothing is changed
    }
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(static_cast<std::uint64_t>(list.size()));
    if constexpr (std::is_arithmetic_v<T>) {
      put_raw(list.data(), list.size() * sizeof(T));
    } else {
      for (const T& element : list) put(element);
    }
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    put_raw(text.data(), text.size());
  }
  template <class T>
  void put(const std::optional<T>& thing) {
    put(thing.has_value());
    if (thing) put(*thing);
  }
  void put_raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::byte> bytes_;
};

/// Reads things from bytes, which may be anything: throws Failure(bad_input) if they are no such things.
class ByteReader {
 public:
  static constexpr bool reading = true;

  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... things) {
    (get(things), ...);
  }
  /// To be called last: all bytes must have been used.
  void end() const { require(rest_.empty()); }
  static void require(bool sound) {
    if (!sound) throw Failure(Exit::bad_input, "the saved bytes are damaged or of another version");
  }

 private:
  template <class T>
  void get(T& thing) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      get(byte);
      require(byte <= 1);
      thing = byte == 1;
    } else if constexpr (std::is_arithmetic_v<T>) {
      get_raw(&thing, sizeof thing);
    } else {
      fields(*this, thing);
    }
  }
  template <class T>
  void get(std::vector<T>& list) {
    const std::size_t count = length(std::is_arithmetic_v<T> ? sizeof(T) : 1);
    list.clear();
    if constexpr (std::is_arithmetic_v<T>) {
      list.resize(count);
      get_raw(list.data(), count * sizeof(T));
    } else {
      // A false length must not ask for more memory than the bytes that are there could fill.
      list.reserve(std::min(count, rest_.size() / sizeof(T)));
      for (std::size_t k = 0; k < count; ++k) get(list.emplace_back());
    }
  }
  void get(std::string& text) {
    text.resize(length(1));
    get_raw(text.data(), text.size());
  }
  template <class T>
  void get(std::optional<T>& thing) {
    bool there = false;
    get(there);
    thing.reset();
    if (there) get(thing.emplace());
  }
  std::size_t length(std::size_t least_size) {
    std::uint64_t count = 0;
    get(count);
    require(count <= rest_.size() / least_size);
    return count;
  }
  void get_raw(void* data, std::size_t size) {
    require(size <= rest_.size());
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const std::byte> rest_;
};

template <class... T>
std::vector<std::byte> to_bytes(const T&... things) {
  ByteWriter writer;
  writer(things...);
  return writer.take();
}

/// Throws Failure(bad_input) unless the bytes are exactly these things, one after the other.
template <class... T>
void from_bytes(std::span<const std::byte> bytes, T&... things) {
  ByteReader reader(bytes);
  reader(things...);
  reader.end();
}

}  // namespace pulvis
