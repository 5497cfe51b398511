// SPDX-License-Identifier: Apache-2.0
#include "run/bed_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t most_parcels = 200'000'000;

class DumpReader {
 public:
  DumpReader(const std::string& path) : path_(path), file_(path) {
    if (!file_)
      throw Failure(Exit::bad_input,
                    fmt::format("cannot read {}\n  check the path in the source's `path`", path));
  }

  struct Row {
    std::uint64_t id;
    Parcel parcel;
  };

  std::vector<Row> last_frame() {
    std::vector<Row> rows;
    bool any = false;
    while (next_line()) {
      skip_units_and_time();
      if (!starts("ITEM: TIMESTEP"))
        fail("expected \"ITEM: TIMESTEP\"; this is not a LIGGGHTS or LAMMPS text dump");
      rows = frame();
      any = true;
    }
    if (!any) fail("the file is empty");
    return rows;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Failure(Exit::bad_input, fmt::format("{}:{}: error: {}", path_, number_, message));
  }

  bool next_line() {
    if (!std::getline(file_, line_)) return false;
    ++number_;
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    return true;
  }
  void need_line(const char* what) {
    if (!next_line()) fail(fmt::format("the file ends where {} should follow; was it cut off?", what));
  }

  bool starts(const char* item) const { return line_.rfind(item, 0) == 0; }

  // What LAMMPS writes ahead of a frame with "dump_modify units yes time yes".
  void skip_units_and_time() {
    while (starts("ITEM: UNITS") || (starts("ITEM: TIME") && !starts("ITEM: TIMESTEP"))) {
      const bool units = starts("ITEM: UNITS");
      need_line("the value of this item");
      // "lj" has no units of its own; granular scripts use it for SI numbers.
      if (units && line_ != "si" && line_ != "lj")
        fail(fmt::format("the dump is in units \"{}\"; dumps must be in SI units", line_.substr(0, 40)));
      need_line("ITEM: TIMESTEP");
    }
  }

  double number_in(const std::string& word) const {
    double value = 0.0;
    const auto end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
      fail(fmt::format("\"{}\" is not a finite number", word.substr(0, 40)));
    return value;
  }

  std::vector<Row> frame() {
    need_line("the time step");
    need_line("ITEM: NUMBER OF ATOMS");
    if (!starts("ITEM: NUMBER OF ATOMS")) fail("expected \"ITEM: NUMBER OF ATOMS\"");
    need_line("the number of atoms");
    const double count = number_in(line_);
    if (count < 0 || count > static_cast<double>(most_parcels) || count != std::floor(count))
      fail("the number of atoms makes no sense");
    need_line("ITEM: BOX BOUNDS");
    if (!starts("ITEM: BOX BOUNDS")) fail("expected \"ITEM: BOX BOUNDS\"");
    for (int axis = 0; axis < 3; ++axis) need_line("the bounds of the box");
    need_line("ITEM: ATOMS");
    if (!starts("ITEM: ATOMS")) fail("expected \"ITEM: ATOMS\" with the names of the columns");
    find_columns();
    type_.reset();
    std::vector<Row> rows;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(count); ++k) {
      need_line("an atom");
      rows.push_back(row());
    }
    return rows;
  }

  void find_columns() {
    column_.clear();
    std::istringstream words(line_.substr(11));
    std::string word;
    for (std::size_t k = 0; words >> word; ++k)
      if (!column_.emplace(word, k).second)
        fail(fmt::format("the dump has two columns \"{}\"", word.substr(0, 40)));
    for (const char* needed : {"id", "x", "y", "z"})
      if (!column_.count(needed)) fail(fmt::format("the dump has no column \"{}\"", needed));
    if (!column_.count("radius") && !column_.count("diameter")) fail("the dump has no column \"radius\"");
  }

  // A bed is of one powder; parcels of a second one would silently turn into the first.
  void check_type(double type) {
    if (type_ && *type_ != type)
      fail(
          fmt::format("the dump has atoms of type {:g} and of type {:g}; a bed is of one powder\n  write one "
                      "dump for each type, and give each a source of its own",
                      *type_, type));
    type_ = type;
  }

  Row row() {
    std::istringstream words(line_);
    std::vector<std::string> cells;
    for (std::string word; words >> word;) cells.push_back(word);
    if (cells.size() != column_.size())
      fail(fmt::format("{} values where there are {} columns", cells.size(), column_.size()));
    const auto value = [&](const char* name) {
      const auto at = column_.find(name);
      return at == column_.end() ? 0.0 : number_in(cells[at->second]);
    };
    Row r;
    const double id = value("id");
    if (id < 0 || id > 4e15 || id != std::floor(id))
      fail(fmt::format("the id {} is no whole number that can be", cells[column_.at("id")].substr(0, 40)));
    if (column_.count("type")) check_type(value("type"));
    r.id = static_cast<std::uint64_t>(id);
    r.parcel.position = {value("x"), value("y"), value("z")};
    r.parcel.velocity = {value("vx"), value("vy"), value("vz")};
    r.parcel.spin = {value("omegax"), value("omegay"), value("omegaz")};
    r.parcel.radius = column_.count("radius") ? value("radius") : 0.5 * value("diameter");
    if (!(r.parcel.radius > 0.0)) fail("a radius that is not positive");
    return r;
  }

  std::string path_;
  std::ifstream file_;
  std::string line_;
  std::uint64_t number_ = 0;
  std::map<std::string, std::size_t> column_;
  std::optional<double> type_;  // of the atoms of this frame so far
};

/// Dumps may have parcels just beyond a periodic end, which another program's wrapping left there.
void wrap_once(const Box& domain, Vec3& position) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic[axis]) continue;
    const double length = domain.max[axis] - domain.min[axis];
    if (position[axis] < domain.min[axis])
      position[axis] += length;
    else if (position[axis] > domain.max[axis])
      position[axis] -= length;
  }
}

}  // namespace

Bed read_bed(const std::string& path, double density, std::uint32_t species, const Box& domain) {
  auto rows = DumpReader(path).last_frame();
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  Bed bed;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0 && rows[k].id == rows[k - 1].id)
      throw Failure(Exit::bad_input, fmt::format("{}: error: the id {} stands twice", path, rows[k].id));
    Parcel p = rows[k].parcel;
    wrap_once(domain, p.position);
    for (int axis = 0; axis < 3; ++axis)
      if (p.position[axis] < domain.min[axis] || p.position[axis] > domain.max[axis])
        throw Failure(
            Exit::bad_input,
            fmt::format("{}: error: parcel {} lies outside the case's domain at ({:g}, {:g}, {:g}) m\n  "
                        "enlarge [domain]; dumps must be in SI units",
                        path, rows[k].id, p.position.x, p.position.y, p.position.z));
    p.mass = density * sphere_volume(p.radius);
    p.species = species;
    bed.parcels.push_back(p);
    bed.ids.push_back(rows[k].id);
  }
  return bed;
}

}  // namespace pulvis
