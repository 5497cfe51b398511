// SPDX-License-Identifier: Apache-2.0
#include "report/case_words.hpp"

#include <fmt/format.h>

#include "case/similarity_words.hpp"
#include "case/units.hpp"

namespace pulvis::report {
namespace {

std::string length(double metres) { return format_quantity(metres, dimension::length); }

std::string size_words(const SizeDistribution& s) {
  using Kind = SizeDistribution::Kind;
  switch (s.kind) {
    case Kind::single:
      return fmt::format("grains of {}, all the same", length(s.diameter));
    case Kind::uniform:
      return fmt::format("grains from {} to {}, all sizes alike", length(s.smallest), length(s.largest));
    case Kind::normal:
      return fmt::format("grains of {} on average, standard deviation {} (normal)", length(s.diameter),
                         length(s.standard_deviation));
    case Kind::lognormal:
      return fmt::format("grains of {} in the median, geometric deviation {:.3g} (lognormal)",
                         length(s.diameter), s.geometric_deviation);
    case Kind::table:
      return s.diameters.empty() ? "grains by a table"
                                 : fmt::format("grains from {} to {} by a table", length(s.diameters.front()),
                                               length(s.diameters.back()));
  }
  return "";
}

std::string powder_words(const Case& c, const Powder& p) {
  const Material& m = c.materials[p.material];
  return fmt::format(
      "{}; {}: density {}, Young's modulus {}, surface energy {}, restitution {:.3g}, friction {:.3g}, "
      "rolling "
      "friction {:.3g}",
      size_words(p.size), m.name, format_quantity(m.density, dimension::density),
      format_quantity(m.young_modulus, dimension::pressure),
      format_quantity(m.surface_energy, dimension::surface_energy), m.restitution, m.friction,
      m.rolling_friction);
}

std::string wall_words(const Case& c, const Wall& w) {
  constexpr const char* shapes[] = {"plane",    "rectangle", "disc",   "box",
                                    "cylinder", "cone",      "sphere", "mesh"};
  std::string text = shapes[static_cast<std::size_t>(w.shape)];
  if (w.shape == Wall::Shape::box) {
    const Vec3 e = w.region.max - w.region.min;
    text += fmt::format(" of {} x {} x {} inside", length(e.x), length(e.y), length(e.z));
  } else if (w.shape == Wall::Shape::cylinder) {
    text += fmt::format(" of diameter {}, height {} inside", length(2.0 * w.region.radius),
                        length(w.region.height));
  }
  for (std::size_t k = 0; k < w.open.size(); ++k) text += (k ? ", " : ", open at ") + w.open[k];
  const Material& m = c.materials[w.material];
  text += fmt::format("; {}: friction {:.3g}, surface energy {}", m.name, m.friction,
                      format_quantity(m.surface_energy, dimension::surface_energy));
  for (std::size_t k = 0; k < w.motions.size(); ++k)
    text += (k ? ", " : "; moved by ") + c.motions[w.motions[k]].name;
  if (c.measures.die && &c.walls[*c.measures.die] == &w) text += "; its inside is measured";
  return text;
}

std::string source_words(const Case& c, const Source& s) {
  if (s.kind == Source::Kind::file) return "a bed read from the file " + s.path;
  std::string text = s.kind == Source::Kind::rain ? "a rain"
                     : s.kind == Source::Kind::dense
                         ? fmt::format("a dense random pack, {:g} solid,", s.solid_fraction)
                         : "a random pack";
  text += fmt::format(" of {}", c.powders[s.powder].name);
  if (s.target.mass) text += ", " + format_quantity(*s.target.mass, dimension::mass);
  if (s.target.count) text += fmt::format(", {} parcels", *s.target.count);
  if (s.kind == Source::Kind::rain) text += " at " + format_quantity(s.mass_rate, dimension::mass_rate);
  if (s.sieve_pitch && s.sieve_opening)
    text += fmt::format(", through a sieve with openings of {} every {}", length(*s.sieve_opening),
                        length(*s.sieve_pitch));
  const double speed = norm(s.velocity);
  if (speed > 0.0) text += fmt::format(", thrown in at {}", format_quantity(speed, dimension::speed));
  return text;
}

std::string contact_words(const ContactChoice& c) {
  std::string text =
      fmt::format("normal force \"{}\", damping \"{}\", sliding \"{}\"", c.normal, c.damping, c.sliding);
  if (c.cohesion != "none") text += fmt::format(", cohesion \"{}\"", c.cohesion);
  if (c.rolling != "none") text += fmt::format(", rolling \"{}\"", c.rolling);
  if (c.twisting != "none") text += fmt::format(", twisting \"{}\"", c.twisting);
  return text;
}

/// From one letter that is no blank to the last.
std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" :\t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

}  // namespace

Words case_words(const Case& c) {
  Words words;
  for (const Powder& p : c.powders) words.emplace_back("powder " + p.name, powder_words(c, p));
  for (const Wall& w : c.walls) words.emplace_back("wall " + w.name, wall_words(c, w));
  words.emplace_back("contact law", contact_words(c.contact));
  for (const Source& s : c.sources) words.emplace_back("source " + s.name, source_words(c, s));
  words.emplace_back("gravity", format_quantity(norm(c.body_force.gravity), dimension::acceleration) +
                                    (c.body_force.rotates() ? ", in a rotating frame" : ""));
  return words;
}

std::string motion_words(const RunData& run, const std::string& motion) {
  const std::string start = "motions." + motion + ".";
  std::string kind, rest;
  for (const Key& key : run.keys) {
    if (!key.name.starts_with(start) || key.origin == "default") continue;
    const std::string name = key.name.substr(start.size());
    std::string value = key.value;
    std::erase(value, '"');
    if (name == "kind")
      kind = value;
    else
      rest += fmt::format("{}{} {}", rest.empty() ? "" : ", ", name, value.size() > 80 ? "(a table)" : value);
  }
  return rest.empty() ? kind : kind + ": " + rest;
}

std::vector<std::string> simplifications(const Case& c) {
  std::vector<std::string> list;
  for (const Powder& p : c.powders) {
    if (p.coarse_graining > 1.0)
      list.push_back(fmt::format(
          "Coarse graining of {}: a parcel is {:.4g} times larger than a grain ({} for {}), under the "
          "similarity "
          "\"{}\". Kept: {}. Not kept: {}.",
          p.name, p.coarse_graining, length(p.coarse_graining * p.size.diameter), length(p.size.diameter),
          c.contact.similarity, what_is_kept(c.contact.similarity), what_is_not_kept(c.contact.similarity)));
    if (p.simulated_modulus)
      list.push_back(
          fmt::format("Softening of {}: Young's modulus {} instead of {}, so that the time step is longer. "
                      "This keeps {}; contacts "
                      "are larger and last longer than real ones.",
                      p.name, format_quantity(*p.simulated_modulus, dimension::pressure),
                      format_quantity(c.materials[p.material].young_modulus, dimension::pressure),
                      p.keep == Powder::Keep::pull_off ? "the pull-off force"
                                                       : "the speed below which collisions stick, by less "
                                                         "surface energy; the pull-off force is smaller"));
  }
  list.push_back("There is no air: nothing escapes through the powder, and fine grains do not float.");
  list.push_back("Parcels are spheres; what the shape of the grains does is left to rolling friction.");
  return list;
}

std::vector<Assumed> assumed_values(const RunData& run) {
  const std::string mark = "ASSUMED";
  std::vector<Assumed> list;
  for (const Key& key : run.keys)
    if (const auto at = key.comment.find(mark); at != std::string::npos)
      list.push_back({key.name, key.value, trimmed(key.comment.substr(at + mark.size()))});
  return list;
}

}  // namespace pulvis::report
