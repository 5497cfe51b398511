// SPDX-License-Identifier: Apache-2.0
#include "output/chunk_file.hpp"

#include <xxhash.h>

#include <cstring>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const std::vector<Chunk> chunks{{"case", bytes_of("a=1")}, {"none", {}}, {"state", bytes_of("0123456789")}};

std::string small_file() {
  ScratchFolder folder;
  write_chunk_file(folder.file("a"), 7, chunks);
  return content_of(folder.file("a"));
}

TEST(ChunkFile, GivesBackItsChunks) {
  ScratchFolder folder;
  write_chunk_file(folder.file("a"), 7, chunks);
  EXPECT_FALSE(folder.has("a.part"));
  const ChunkFile file(folder.file("a"), 7);
  for (const Chunk& chunk : chunks) EXPECT_EQ(text_of(file[chunk.name]), text_of(chunk.bytes));
  EXPECT_NE(failure_of(Exit::bad_input, [&] { file["other"]; }).find("other"), std::string::npos);
}

TEST(ChunkFile, IsWhatItsDocumentSays) {
  const std::string file = small_file();
  const auto number = [&]<class T>(std::size_t at, T) {
    T value;
    std::memcpy(&value, file.data() + at, sizeof value);
    return value;
  };
  EXPECT_EQ(file.substr(0, 8), "PULSCHKP");
  EXPECT_EQ(number(8, std::uint64_t{}), file.size());
  EXPECT_EQ(number(16, std::uint32_t{}), 7u);
  EXPECT_EQ(number(20, std::uint64_t{}), 3u);
  EXPECT_EQ(number(28, std::uint64_t{}), 4u);
  EXPECT_EQ(file.substr(36, 4), "case");
  EXPECT_EQ(number(40, std::uint64_t{}), 3u);
  EXPECT_EQ(number(48, std::uint64_t{}), XXH3_64bits("a=1", 3));
  const std::size_t table = file.size() - 13 - 8;
  EXPECT_EQ(number(table, std::uint64_t{}), XXH3_64bits(file.data(), table));
  EXPECT_EQ(file.substr(table + 8), "a=10123456789");
}

TEST(ChunkFile, NoticesEveryFlippedBit) {
  auto file = bytes_of(small_file());
  for (std::size_t at = 0; at < file.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      file[at] ^= std::byte{1} << bit;
      EXPECT_THROW(ChunkFile(file, "a", 7), Failure) << "bit " << bit << " of byte " << at;
      file[at] ^= std::byte{1} << bit;
    }
  EXPECT_NO_THROW(ChunkFile(file, "a", 7));
}

TEST(ChunkFile, NoticesEveryCutAndWhatWasAppended) {
  const std::string file = small_file();
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_THROW(ChunkFile(bytes_of(file.substr(0, size)), "a", 7), Failure) << "cut to " << size;
  EXPECT_THROW(ChunkFile(bytes_of(file + "x"), "a", 7), Failure);
}

TEST(ChunkFile, SaysWhatIsWrong) {
  std::string file = small_file();
  const auto why = [&](std::uint32_t version) {
    return failure_of(Exit::bad_input, [&] { ChunkFile(bytes_of(file), "some/file", version); });
  };
  EXPECT_NE(why(8).find("version 7"), std::string::npos);
  file.back() = '#';
  EXPECT_NE(why(7).find("chunk state is damaged"), std::string::npos) << why(7);
  EXPECT_EQ(why(7).find("some/file"), 0u);
  file = "#!/bin/sh\n" + file;
  EXPECT_NE(why(7).find("damaged"), std::string::npos) << why(7);
}

TEST(ChunkFile, TakesNoHarmFromATableWithAMendedChecksum) {
  const std::string file = small_file();
  const std::size_t table = file.size() - 13 - 8;
  for (std::size_t at = 0; at < table; ++at)
    for (const char value : {'\0', '\1', '\x7f', '\xff'}) {
      std::string changed = file;
      changed[at] = value;
      const std::uint64_t sum = XXH3_64bits(changed.data(), table);
      std::memcpy(changed.data() + table, &sum, sizeof sum);
      try {
        ChunkFile(bytes_of(changed), "a", 7);
      } catch (const Failure& failure) {
        EXPECT_EQ(failure.code(), Exit::bad_input);
      }
    }
}

TEST(ChunkFile, LeavesTheOldFileWhereTheNewOneDoesNotFit) {
  ScratchFolder folder;
  write_chunk_file(folder.file("a"), 7, chunks);
  const std::string before = content_of(folder.file("a"));
  for (const std::size_t room : {0u, 5u, 60u, static_cast<unsigned>(before.size()) - 1u}) {
    failure_of(Exit::io, [&] { write_chunk_file(folder.file("a"), 7, chunks, SmallDisk::calls(room)); });
    EXPECT_EQ(content_of(folder.file("a")), before);
    EXPECT_FALSE(folder.has("a.part"));
  }
}

TEST(ChunkFile, IsNoFolderAndNoDevice) {
  ScratchFolder folder;
  for (const std::string& path : {folder.path(), folder.file("none"), std::string("/dev/zero")})
    EXPECT_NE(failure_of(Exit::bad_input, [&] { ChunkFile(path, 7); }).find(path), std::string::npos);
}

}  // namespace
}  // namespace pulvis
