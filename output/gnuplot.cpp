// SPDX-License-Identifier: Apache-2.0
#include "output/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

// The palette of M. Okabe and K. Ito (2008), black first.
constexpr std::array colours{"#000000", "#0072b2", "#d55e00", "#009e73",
                             "#cc79a7", "#e69f00", "#56b4e9", "#b0a000"};

/// A nameless file that is gone when it is closed.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
Scratch scratch_file() {
  Scratch file(std::tmpfile(), &std::fclose);
  if (!file) throw Failure(Exit::io, "cannot make a temporary file; is the disk full?");
  return file;
}

std::string text_of(std::FILE* file) {
  std::string text;
  std::array<char, 4096> part{};
  std::rewind(file);
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file)) text.append(part.data(), got);
  return text;
}

struct Finished {
  bool started = false;
  int status = -1;
  std::string out, err;
};

/// gnuplot with a script as its standard input.
Finished run_gnuplot(const std::string& script) {
  const Scratch in = scratch_file(), out = scratch_file(), err = scratch_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw Failure(Exit::io, "cannot write a temporary file; is the disk full?");
  std::rewind(in.get());
  posix_spawn_file_actions_t streams;
  ::posix_spawn_file_actions_init(&streams);
  ::posix_spawn_file_actions_adddup2(&streams, ::fileno(in.get()), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&streams, ::fileno(out.get()), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&streams, ::fileno(err.get()), STDERR_FILENO);
  std::string name = "gnuplot", only_input = "-";
  std::array<char*, 3> words{name.data(), only_input.data(), nullptr};
  pid_t child = 0;
  Finished result;
  result.started = ::posix_spawnp(&child, "gnuplot", &streams, nullptr, words.data(), environ) == 0;
  ::posix_spawn_file_actions_destroy(&streams);
  if (!result.started) return result;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.out = text_of(out.get());
  result.err = text_of(err.get());
  return result;
}

}  // namespace

bool can_draw_figures() {
  const Finished g = run_gnuplot("");
  return g.started && g.status == 0;
}

std::string drawn_by_gnuplot(const std::string& script, const std::string& name) {
  const Finished g = run_gnuplot(script);
  // 127 where the C library only notices in the child that there is no such program.
  if (!g.started || g.status == 127)
    throw Failure(Exit::io,
                  "gnuplot, which draws the figures, is not installed; its Debian package is gnuplot-nox");
  if (g.status != 0 || g.out.find("</svg>") == std::string::npos)
    throw Failure(Exit::io, fmt::format("gnuplot could not draw the figure {}:\n{}", name, g.err));
  return g.out;
}

namespace gnuplot {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    if (c == '\'')
      result += "''";
    else
      result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return result + "'";
}

const char* colour(std::size_t k) { return colours[k % colours.size()]; }

std::string head(int width, int height) {
  return fmt::format(
      "set terminal svg size {},{} noenhanced font 'DejaVu Sans,13' background '#ffffff'\n"
      "set border lc rgb '#404040'\n",
      width, height);
}

std::string data_line(const std::vector<double>& numbers) {
  if (!std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); })) return "\n";
  return fmt::format("{}\n", fmt::join(numbers, " "));
}

}  // namespace gnuplot

std::string csv_quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace pulvis
