// SPDX-License-Identifier: Apache-2.0
#include "output/figure.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"

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
Finished gnuplot(const std::string& script) {
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

/// Text between single quotes of gnuplot.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : c == '\n' ? " " : std::string(1, c);
  return result + "'";
}

std::string script_of(const Figure& figure) {
  std::string script = fmt::format(
      "set terminal svg size 720,440 noenhanced font 'DejaVu Sans,13' background '#ffffff'\n"
      "set title {}\nset xlabel {}\nset ylabel {}\nset grid lc rgb '#d0d0d0'\nset border lc rgb '#404040'\n"
      "set key outside right top vertical Left reverse samplen 2\nset style data lines\n",
      quoted(figure.title), quoted(figure.x_label), quoted(figure.y_label));
  if (figure.log_x) script += "set logscale x\nset format x '%.0e'\n";
  if (figure.log_y) script += "set logscale y\n";
  std::string plot = "plot", data;
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    const Curve& curve = figure.curves[k];
    const char* colour = colours[k % colours.size()];
    plot += fmt::format("{} '-' using 1:2 title {} ", k ? "," : "", quoted(curve.label));
    plot += curve.points ? fmt::format("with points pt {} ps 0.7 lc rgb '{}'", 4 + k % 10, colour)
                         : fmt::format("with lines lw 1.8 dt {} lc rgb '{}'", 1 + k / colours.size(), colour);
    for (std::size_t j = 0; j < curve.x.size(); ++j)
      data += std::isfinite(curve.x[j]) && std::isfinite(curve.y[j])
                  ? fmt::format("{} {}\n", curve.x[j], curve.y[j])
                  : "\n";
    data += "e\n";
  }
  return script + plot + "\n" + data;
}

}  // namespace

bool can_draw_figures() {
  const Finished g = gnuplot("");
  return g.started && g.status == 0;
}

std::string figure_svg(const Figure& figure) {
  const Finished g = gnuplot(script_of(figure));
  // 127 where the C library only notices in the child that there is no such program.
  if (!g.started || g.status == 127)
    throw Failure(Exit::io,
                  "gnuplot, which draws the figures, is not installed; its Debian package is gnuplot-nox");
  if (g.status != 0 || g.out.find("</svg>") == std::string::npos)
    throw Failure(Exit::io, fmt::format("gnuplot could not draw the figure {}:\n{}", figure.name, g.err));
  return g.out;
}

std::string figure_csv(const Figure& figure) {
  const auto cell = [](const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
  };
  std::string text = fmt::format("curve,{},{}\n", cell(figure.x_label), cell(figure.y_label));
  for (const Curve& curve : figure.curves)
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      text += fmt::format("{},{},{}\n", cell(curve.label), curve.x[k], curve.y[k]);
  return text;
}

void write_figure(const std::string& folder, const Figure& figure) {
  const std::filesystem::path base = std::filesystem::path(folder) / figure.name;
  write_file_safely(base.string() + ".csv", figure_csv(figure));
  write_file_safely(base.string() + ".svg", figure_svg(figure));
}

}  // namespace pulvis
