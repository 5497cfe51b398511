// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation/state.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t magic = 0x31455441'54534c50;  // "PLSTATE1" read as little-endian text
constexpr std::uint32_t version = 3;

class Writer {
 public:
  std::vector<std::byte> bytes;

  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* p = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), p, p + sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    static_assert(std::is_trivially_copyable_v<T>);
    (*this)(static_cast<std::uint64_t>(list.size()));
    const auto* p = reinterpret_cast<const std::byte*>(list.data());
    bytes.insert(bytes.end(), p, p + list.size() * sizeof(T));
  }
  void operator()(const std::string& text) { (*this)(std::vector<char>(text.begin(), text.end())); }
};

class Reader {
 public:
  explicit Reader(const std::vector<std::byte>& bytes, std::size_t end) : bytes_(bytes), end_(end) {}

  template <class T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    need(sizeof value);
    std::memcpy(static_cast<void*>(&value), bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > (end_ - at_) / sizeof(T)) fail();
    list.resize(count);
    if (count > 0) std::memcpy(static_cast<void*>(list.data()), bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
  }
  void operator()(std::string& text) {
    std::vector<char> letters;
    (*this)(letters);
    text.assign(letters.begin(), letters.end());
  }
  bool at_end() const { return at_ == end_; }
  [[noreturn]] static void fail() {
    throw Failure(Exit::bad_input, "the saved state is damaged or of another version");
  }

 private:
  void need(std::size_t size) const {
    if (size > end_ - at_) fail();
  }
  const std::vector<std::byte>& bytes_;
  std::size_t at_ = 0, end_;
};

/// Every field of the state, once; writing and reading use the same list.
template <class Archive, class S>
void visit(Archive& archive, S& s) {
  archive(s.step);
  archive(s.parcels.body);
  archive(s.parcels.load);
  for (auto* list : {&s.pairs, &s.walls}) {
    archive(list->begin);
    archive(list->partner);
    archive(list->history);
    archive(list->memory.used);
    archive(list->memory.list);
  }
  archive(s.motions);
  archive(s.body_absent);
  archive(s.sources);
  archive(s.next_id);
  archive(s.ledger);
  std::uint64_t escapes = s.escapes.size();
  archive(escapes);
  if constexpr (!std::is_const_v<S>) {
    if (escapes > s.parcels.size() + s.ledger.inserted) Reader::fail();
    s.escapes.resize(escapes);
  }
  for (auto& e : s.escapes) {
    archive(e.id);
    archive(e.time);
    archive(e.position);
    archive(e.velocity);
    archive(e.through);
  }
  archive(s.progress);
}

class Hash {
 public:
  Hash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_); }
  ~Hash() { XXH3_freeState(state_); }
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  template <class T>
  void add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Vec3> ||
                  std::is_same_v<T, double> || std::is_same_v<T, laws::History> ||
                  std::is_same_v<T, laws::Memory>);
    XXH3_128bits_update(state_, &value, sizeof value);
  }
  std::string text() const {
    const auto digest = XXH3_128bits_digest(state_);
    return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
  }

 private:
  XXH3_state_t* state_;
};

void add_contacts(Hash& hash, const TouchingList& list, std::uint32_t owner) {
  hash.add(list.begin[owner + 1] - list.begin[owner]);
  for (std::uint32_t k = list.begin[owner]; k < list.begin[owner + 1]; ++k) {
    hash.add(list.partner[k]);
    hash.add(list.history[k]);
    if (list.memory.used) hash.add(list.memory.list[k]);
  }
}

}  // namespace

std::vector<std::byte> save_state(const State& state) {
  Writer writer;
  writer(magic);
  writer(version);
  visit(writer, state);
  writer(static_cast<std::uint64_t>(XXH3_64bits(writer.bytes.data(), writer.bytes.size())));
  return writer.bytes;
}

State load_state(const std::vector<std::byte>& bytes) {
  std::uint64_t checksum = 0;
  if (bytes.size() < sizeof magic + sizeof version + sizeof checksum) Reader::fail();
  const std::size_t end = bytes.size() - sizeof checksum;
  std::memcpy(&checksum, bytes.data() + end, sizeof checksum);
  if (checksum != XXH3_64bits(bytes.data(), end)) Reader::fail();
  Reader reader(bytes, end);
  std::uint64_t read_magic = 0;
  std::uint32_t read_version = 0;
  reader(read_magic);
  reader(read_version);
  if (read_magic != magic || read_version != version) Reader::fail();
  State state;
  visit(reader, state);
  if (!reader.at_end()) Reader::fail();
  return state;
}

std::string state_hash(const Parcels& parcels, const TouchingList& pairs, const TouchingList& walls) {
  const std::size_t count = parcels.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return parcels.body[a].id < parcels.body[b].id; });
  Hash hash;
  for (const std::uint32_t k : order) {
    const Parcel& p = parcels.body[k];
    hash.add(p.id);
    hash.add(p.position);
    hash.add(p.velocity);
    hash.add(p.spin);
    add_contacts(hash, pairs, k);
    add_contacts(hash, walls, k);
  }
  return hash.text();
}

}  // namespace pulvis
