// SPDX-License-Identifier: Apache-2.0
#include "run/law_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "run/pair_numbers.hpp"
#include "single_contact/collision.hpp"
#include "single_contact/curve.hpp"

namespace pulvis {
namespace {

std::string pair_name(const Assembly& a, const PairProperties& p) {
  return a.species[p.first].name + " / " + a.species[p.second].name;
}

bool is_called(const Case& c, const Species& s, const std::string& name) {
  return s.name == name || c.materials[s.material].name == name;
}

void check_name(const Case& c, const Assembly& a, const std::string& name) {
  const auto called = [&](const Species& s) { return is_called(c, s, name); };
  if (std::any_of(a.species.begin(), a.species.end(), called)) return;
  for (const Material& m : c.materials)
    if (m.name == name)
      throw Failure(Exit::usage,
                    fmt::format("--pair: no powder and no wall of the case is of \"{}\", so that "
                                "nothing meets it",
                                name));
  std::string known;
  for (const Material& m : c.materials) known += (known.empty() ? "" : ", ") + m.name;
  for (const Powder& p : c.powders)
    if (p.name != c.materials[p.material].name) known += ", " + p.name;
  throw Failure(Exit::usage,
                fmt::format("--pair: the case has no material or powder \"{}\"; it has {}", name, known));
}

std::vector<PairProperties> chosen_pairs(const Case& c, const Assembly& a,
                                         const std::vector<std::string>& names) {
  if (names.empty()) return a.pairs;
  for (const std::string& name : names) check_name(c, a, name);
  std::vector<PairProperties> chosen;
  for (const PairProperties& p : a.pairs) {
    const Species &first = a.species[p.first], &second = a.species[p.second];
    if ((is_called(c, first, names[0]) && is_called(c, second, names[1])) ||
        (is_called(c, first, names[1]) && is_called(c, second, names[0])))
      chosen.push_back(p);
  }
  if (!chosen.empty()) return chosen;
  std::string meet;
  for (const PairProperties& p : a.pairs) meet += "\n  " + pair_name(a, p);
  throw Failure(Exit::usage,
                fmt::format("--pair: {} and {} cannot meet: both are walls only; what can meet is{}",
                            names[0], names[1], meet));
}

/// A row of the table. Zero is what the contact does not have.
std::string row(const std::string& what, const std::string& grain, const std::string& parcel) {
  return fmt::format("  {:<42} {:>22} {:>22}\n", what, grain, parcel);
}

std::string value_text(double x, const Dimension& dimension) {
  if (x == 0.0) return "-";
  return dimension == dimension::none ? fmt::format("{:.4g}", x) : format_quantity(x, dimension);
}

std::string speeds_text(const single_contact::StickingSpeeds& speeds) {
  if (speeds.highest == 0.0) return "-";
  const std::string highest =
      std::isinf(speeds.highest) ? "any" : format_quantity(speeds.highest, dimension::speed, 3);
  if (speeds.lowest == 0.0) return std::isinf(speeds.highest) ? highest : "below " + highest;
  return fmt::format("{} to {}", format_quantity(speeds.lowest, dimension::speed, 3), highest);
}

class Table {
 public:
  Table(const PairNumbers& grain, const PairNumbers& parcel) : grain_(grain), parcel_(parcel) {}

  /// A row of what `text_of(numbers)` says of each of the two.
  template <class Text>
  void add_text(const std::string& what, Text text_of) {
    const auto one = [&](const PairNumbers& n) -> std::string {
      return n.adhesion.holds ? text_of(n) : "collapses";
    };
    text += row(what, one(grain_), one(parcel_));
  }
  template <class Value>
  void add(const std::string& what, const Dimension& dimension, Value value) {
    add_text(what, [&](const PairNumbers& n) { return value_text(value(n), dimension); });
  }

  std::string text;

 private:
  const PairNumbers &grain_, &parcel_;
};

void add_adhesion(Table& table) {
  table.add("pull-off force", dimension::force, [](const PairNumbers& n) { return n.adhesion.pull_off; });
  table.add("  over the weight (Bond number)", dimension::none,
            [](const PairNumbers& n) { return n.bond(); });
  table.add("overlap without force", dimension::length,
            [](const PairNumbers& n) { return n.adhesion.zero_force_overlap; });
  table.add("  over the radius, %", dimension::none,
            [](const PairNumbers& n) { return 100.0 * n.adhesion.zero_force_overlap / n.radius; });
  table.add("attraction begins on approach at the gap", dimension::length,
            [](const PairNumbers& n) { return n.contact.formation_gap(); });
  table.add("contact breaks at the gap", dimension::length,
            [](const PairNumbers& n) { return n.contact.separation_gap(); });
  table.add("work to pull apart from rest", dimension::energy,
            [](const PairNumbers& n) { return n.adhesion.separation_work; });
  table.add("work lost by touch and separation", dimension::energy,
            [](const PairNumbers& n) { return n.adhesion.lost_work; });
  table.add_text("collisions stick, without damping",
                 [](const PairNumbers& n) { return speeds_text(n.undamped_sticking); });
  table.add_text("collisions stick, with damping", [](const PairNumbers& n) {
    return speeds_text(single_contact::sticking_speeds(n.contact, n.speed_scale));
  });
}

std::string restitution_text(const PairNumbers& n, const single_contact::Collision& c) {
  if (!n.adhesion.holds || c.is_crushed) return "collapses";
  return c.sticks ? "sticks" : fmt::format("{:.4f}", c.restitution);
}

void add_collisions(Table& table, const PairNumbers& grain, const PairNumbers& parcel,
                    const std::vector<double>& speeds, double step) {
  for (const double speed : speeds) {
    const single_contact::Collision g = single_contact::collide(grain.contact, speed),
                                    p = single_contact::collide(parcel.contact, speed);
    const std::string at = format_quantity(speed, dimension::speed, 3);
    table.text += row(fmt::format("restitution at {} ({:.4g} asked)", at, parcel.restitution),
                      restitution_text(grain, g), restitution_text(parcel, p));
    table.text += row("  at the time step of the case", "",
                      restitution_text(parcel, single_contact::collide(parcel.contact, speed, step)));
    if (speed != speeds.back() || p.is_crushed || g.is_crushed) continue;
    table.text += row("  largest overlap over the radius, %",
                      fmt::format("{:.3g}", 100.0 * g.largest_overlap / grain.radius),
                      fmt::format("{:.3g}", 100.0 * p.largest_overlap / parcel.radius));
    table.text +=
        row("  duration, and time steps of it", format_quantity(g.duration, dimension::time),
            fmt::format("{}, {:.0f}", format_quantity(p.duration, dimension::time), p.duration / step));
  }
}

/// To where a curve is loaded: where the attraction shows, twice the overlap without force; else, and where the law
/// remembers how deep it was, what a collision reaches.
double largest_overlap(const PairNumbers& n, double speed) {
  if (!n.adhesion.holds) return 0.01 * n.radius;
  const double own = 2.0 * n.adhesion.zero_force_overlap;
  if (own > 0.0 && !n.contact.remembers()) return own;
  return std::max(single_contact::collide(n.contact.undamped(), speed).largest_overlap, own);
}

Curve curve_of(const std::string& label, const std::vector<single_contact::CurvePoint>& points) {
  Curve curve;
  curve.label = label;
  for (const auto& [overlap, force] : points) curve.x.push_back(overlap), curve.y.push_back(force);
  return curve;
}

/// A name of letters, digits and hyphens that no figure has yet.
std::string figure_name(std::string name, const std::vector<Figure>& figures) {
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '-';
  const auto both_hyphens = [](char a, char b) { return a == '-' && b == '-'; };
  name.erase(std::unique(name.begin(), name.end(), both_hyphens), name.end());
  const auto is_taken = [&](const std::string& candidate) {
    return std::any_of(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == candidate; });
  };
  std::string candidate = name;
  for (int k = 2; is_taken(candidate); ++k) candidate = fmt::format("{}-{}", name, k);
  return candidate;
}

Figure figure_of(const std::string& pair, const char* scale, const PairNumbers& n, double speed,
                 const std::vector<Figure>& others) {
  const single_contact::Curve curve = single_contact::load_unload_curve(n.contact, largest_overlap(n, speed));
  Figure figure;
  figure.name = figure_name(pair + " " + scale, others);
  figure.title = fmt::format("{}, {} of {}", pair, scale, format_quantity(2.0 * n.radius, dimension::length));
  figure.x_label = "overlap (m)";
  figure.y_label = "force (N), positive pushes apart";
  figure.curves = {curve_of("pressing", curve.loading), curve_of("coming back", curve.unloading)};
  // Beyond its ends there is no contact: the jumps show.
  const double begins = -n.contact.formation_gap(), breaks = -n.contact.separation_gap(),
               end = breaks - 0.1 * (curve.loading.back().overlap - breaks);
  figure.curves[0].x.insert(figure.curves[0].x.begin(), {end, begins});
  figure.curves[0].y.insert(figure.curves[0].y.begin(), {0.0, 0.0});
  figure.curves[1].x.insert(figure.curves[1].x.end(), {breaks, end});
  figure.curves[1].y.insert(figure.curves[1].y.end(), {0.0, 0.0});
  return figure;
}

std::string heading(const Assembly& a, const PairProperties& p, const PairNumbers& grain,
                    const PairNumbers& parcel) {
  std::string text = fmt::format("\n{}", pair_name(a, p));
  if (parcel.contact.remembers())
    text += fmt::format(", after a load of {} on the grain and {} on the parcel",
                        format_quantity(grain.load, dimension::force),
                        format_quantity(parcel.load, dimension::force));
  const auto diameter = [](const PairNumbers& n) {
    return format_quantity(2.0 * n.radius, dimension::length);
  };
  return text + "\n" + row("", "real grain", "simulated parcel") +
         row("diameter (d50)", diameter(grain), diameter(parcel));
}

}  // namespace

double speed_from(const std::string& text) {
  const QuantityReading reading = read_quantity(text);
  if (!reading.quantity) throw Failure(Exit::usage, fmt::format("--speed {}: {}", text, reading.message));
  if (reading.quantity->dimension != dimension::speed || !(reading.quantity->value >= 1e-9) ||
      !(reading.quantity->value <= 1e4))
    throw Failure(Exit::usage,
                  fmt::format("--speed {}: expected a speed from 1e-9 to 1e4 m/s, like \"0.1 m/s\"", text));
  return reading.quantity->value;
}

LawReport law_report(const Case& c, const Assembly& a, const Forecast& f, const LawRequest& request) {
  const std::vector<PairProperties> pairs = chosen_pairs(c, a, request.pair);
  const double characteristic = a.time_step.characteristic_speed;
  std::vector<double> speeds = request.speeds;
  if (speeds.empty()) speeds = {0.1 * characteristic, 0.3 * characteristic, characteristic};
  std::sort(speeds.begin(), speeds.end());
  LawReport report;
  report.text = fmt::format("{}: normal {}, cohesion {}, damping {}; characteristic speed {}, time step {}\n",
                            c.file, c.contact.normal, c.contact.cohesion, c.contact.damping,
                            format_quantity(characteristic, dimension::speed),
                            format_quantity(a.time_step.step, dimension::time));
  for (const PairProperties& p : pairs) {
    const std::string name = pair_name(a, p);
    const PairNumbers grain = pair_numbers(c, a.species, p, Scale::grain, f.bed_stress, characteristic),
                      parcel = pair_numbers(c, a.species, p, Scale::parcel, f.bed_stress, characteristic);
    Table table(grain, parcel);
    add_adhesion(table);
    add_collisions(table, grain, parcel, speeds, a.time_step.step);
    report.text += heading(a, p, grain, parcel) + table.text;
    for (const StepLimit& limit : a.time_step.limits)
      if (limit.of == name)
        report.text += row(fmt::format("time-step limit: {}", limit.kind), "",
                           format_quantity(limit.time, dimension::time));
    for (const std::string& warning : f.warnings)
      if (warning.starts_with(name + ":") || warning.starts_with(name + " "))
        report.warnings.push_back(warning);
    report.figures.push_back(figure_of(name, "grain", grain, speeds.back(), report.figures));
    report.figures.push_back(figure_of(name, "parcel", parcel, speeds.back(), report.figures));
  }
  return report;
}

void write_curves(const std::string& folder, const LawReport& report) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(Exit::io, fmt::format("cannot create {}: {}", folder, error.message()));
  for (const Figure& figure : report.figures) write_figure(folder, figure);
}

}  // namespace pulvis
