// SPDX-License-Identifier: Apache-2.0
#include "case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace pulvis::case_file {
namespace {

constexpr const char* axis_names = "xyz";

constexpr double rounding = 1e-9;  // m; of what is computed from several keys

std::string length_text(double value) { return format_quantity(value, dimension::length, 6); }

// Corners of a box in order, each axis by itself.
void corners_in_order(const Section& section, ProblemList& problems) {
  const Setting* min = section.find("min");
  const Setting* max = section.find("max");
  if (min == nullptr || max == nullptr) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (min->numbers[axis] < max->numbers[axis]) continue;
    problems.add(
        max->item_places[axis],
        fmt::format("{} is not above {}.min along {}: {} and {}", max->path, section.path, axis_names[axis],
                    length_text(max->numbers[axis]), length_text(min->numbers[axis])),
        "expected min < max along each axis" + problems.see(places_of({min})));
  }
}

bool is_shape(const Section& section, const std::string& shape) {
  const std::string* text = section.optional_text("shape");
  return text != nullptr && *text == shape;
}

// How far an upright or tilted cylinder reaches along an axis.
std::optional<std::pair<double, double>> reach_of_cylinder(const Section& shape, std::size_t along) {
  const Setting *base = shape.find("base"), *radius = shape.find("radius"), *height = shape.find("height");
  if (base == nullptr || radius == nullptr || height == nullptr || shape.find("axis") == nullptr)
    return std::nullopt;
  const double direction = shape.unit_vector("axis")[static_cast<int>(along)];
  const double side = radius->numbers[0] * std::sqrt(std::max(1.0 - direction * direction, 0.0));
  const double start = base->numbers[along], end = start + direction * height->numbers[0];
  return std::pair(std::min(start, end) - side, std::max(start, end) + side);
}

void cylinder_inside_domain(const Section& region, const Section& domain, ProblemList& problems) {
  const Setting *low = domain.find("min"), *high = domain.find("max");
  if (!is_shape(region, "cylinder") || low == nullptr || high == nullptr) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto reach = reach_of_cylinder(region, axis);
    if (!reach || low->numbers[axis] >= high->numbers[axis]) continue;
    const bool below = reach->first < low->numbers[axis] - rounding;
    if (!below && reach->second <= high->numbers[axis] + rounding) continue;
    const Setting& bound = below ? *low : *high;
    problems.add(region.place_of("base"),
                 fmt::format("{} reaches outside the domain along {}: to {}", region.path, axis_names[axis],
                             length_text(below ? reach->first : reach->second)),
                 fmt::format("expected {} {} ({})", below ? "at least" : "at most",
                             length_text(bound.numbers[axis]), bound.path) +
                     problems.see(places_of({&bound})));
  }
}

// What appears outside the domain would be lost at once; along a periodic axis, too, positions are inside.
void inside_domain(const Section& region, const Section& domain, ProblemList& problems) {
  cylinder_inside_domain(region, domain, problems);
  const Setting *low = domain.find("min"), *high = domain.find("max");
  const Setting *min = region.find("min"), *max = region.find("max");
  if (!is_shape(region, "box") || low == nullptr || high == nullptr || min == nullptr || max == nullptr)
    return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (low->numbers[axis] >= high->numbers[axis]) continue;  // reported at the domain
    const bool below = min->numbers[axis] < low->numbers[axis];
    if (!below && max->numbers[axis] <= high->numbers[axis]) continue;
    const Setting& wrong = below ? *min : *max;
    const Setting& bound = below ? *low : *high;
    problems.add(wrong.item_places[axis],
                 fmt::format("{} lies outside the domain along {}: {}", wrong.path, axis_names[axis],
                             length_text(wrong.numbers[axis])),
                 fmt::format("expected {} {} ({})", below ? "at least" : "at most",
                             length_text(bound.numbers[axis]), bound.path) +
                     problems.see(places_of({&bound})));
  }
}

// Of boxes and cylinders; other walls are looked at when they are built.
std::optional<std::pair<double, double>> reach_of(const Section& shape, std::size_t axis) {
  if (is_shape(shape, "cylinder")) return reach_of_cylinder(shape, axis);
  const Setting *min = shape.find("min"), *max = shape.find("max");
  if (min == nullptr || max == nullptr) return std::nullopt;
  return std::pair(min->numbers[axis], max->numbers[axis]);
}

// Where it is written how far a wall reaches, and what else is given.
std::vector<Place> reach_follows_from(const Section& wall, std::initializer_list<const Setting*> besides) {
  std::vector<Place> places = places_of(besides);
  for (const char* key : {"min", "max", "base", "axis", "radius", "height"})
    if (wall.find(key) != nullptr && wall.find(key)->given) places.push_back(wall.find(key)->place);
  return places;
}

// Parcels meet a wall where it is written, not its images: what lies beyond a periodic end holds nothing.
void wall_fits_periodic_axis(const Section& wall, const Section& domain, std::size_t axis,
                             ProblemList& problems) {
  const Setting* periodic = domain.find("periodic");
  if (is_shape(wall, "plane")) {
    if (wall.find("normal") == nullptr || wall.unit_vector("normal")[static_cast<int>(axis)] == 0.0) return;
    return problems.add(wall.place_of("normal"),
                        fmt::format("{} cuts the periodic axis {}", wall.path, axis_names[axis]),
                        fmt::format("expected a normal without a part along {}", axis_names[axis]) +
                            problems.see(places_of({periodic})));
  }
  const Setting *low = domain.find("min"), *high = domain.find("max");
  const auto reach = reach_of(wall, axis);
  if (low == nullptr || high == nullptr || !reach) return;
  if (low->numbers[axis] >= high->numbers[axis]) return;  // reported at the domain
  if (reach->first >= low->numbers[axis] - rounding && reach->second <= high->numbers[axis] + rounding)
    return;
  problems.add(
      wall.place,
      fmt::format("{} reaches beyond the domain along the periodic axis {}: {} to {}", wall.path,
                  axis_names[axis], length_text(reach->first), length_text(reach->second)),
      fmt::format("expected {} to {}", length_text(low->numbers[axis]), length_text(high->numbers[axis])) +
          problems.see(reach_follows_from(wall, {periodic, low, high})));
}

void walls_fit_periodic_axes(const Section& root, ProblemList& problems) {
  const Section& domain = root.table("domain");
  const Setting* periodic = domain.find("periodic");
  if (periodic == nullptr) return;
  for (const Section& wall : root.group("walls"))
    for (const std::string& axis : periodic->texts)
      wall_fits_periodic_axis(wall, domain, static_cast<std::size_t>(axis.front() - 'x'), problems);
}

void pairs_once(const Section& root, ProblemList& problems) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const Section& pair : root.group("pairs")) {
    const Setting* materials = pair.find("materials");
    if (materials == nullptr) continue;
    auto names = std::pair(materials->texts[0], materials->texts[1]);
    if (names.first > names.second) std::swap(names.first, names.second);
    if (seen.insert(names).second) continue;
    problems.add(materials->place, fmt::format("{} names a pair for the second time", materials->path),
                 "each pair of materials stands in one [[pairs]]");
  }
}

// A number of the contact law that the law of this case does not ask for would be silently ignored.
void pairs_fit_the_law(const Section& root, ProblemList& problems) {
  const Section& contact = root.table("contact");
  for (const Section& pair : root.group("pairs"))
    for (const auto& [name, setting] : pair.settings) {
      const Key* key = find_key("contact", name);
      if (key == nullptr || !setting.given) continue;
      const std::string* part = contact.optional_text(key->only_when.key);
      const auto& parts = key->only_when.values;
      if (part == nullptr || std::find(parts.begin(), parts.end(), *part) != parts.end()) continue;
      problems.add(setting.key_place,
                   fmt::format("{} has no meaning where contact.{} is \"{}\"", setting.path,
                               key->only_when.key, *part),
                   fmt::format("it counts where contact.{}", describe_condition(key->only_when)) +
                       problems.see(places_of({contact.find(key->only_when.key)})));
    }
}

// A range cannot say this; another number would be taken for the nearest law.
void exponents_exist(const Section& contact, ProblemList& problems) {
  const auto one_of = [&](const char* name, const std::vector<double>& values, const char* expected) {
    const Setting* setting = contact.find(name);
    if (setting == nullptr || std::find(values.begin(), values.end(), setting->numbers[0]) != values.end())
      return;
    problems.add(setting->place,
                 fmt::format("{} = {:g} is no exponent of the law", setting->path, setting->numbers[0]),
                 expected);
  };
  one_of("loading_exponent", {1.0, 1.5}, "expected 1 or 1.5");
  one_of("adhesion_exponent", {1.0, 1.5, 2.0}, "expected 1, 1.5 or 2");
}

void not_below(const Section& section, const std::string& small, const std::string& large,
               ProblemList& problems) {
  const Setting *low = section.find(small), *high = section.find(large);
  if (low == nullptr || high == nullptr || low->numbers[0] < high->numbers[0]) return;
  problems.add(section.place_of(large),
               fmt::format("{} is not above {}: {} and {}", high->path, low->path,
                           length_text(high->numbers[0]), length_text(low->numbers[0])),
               fmt::format("expected {} < {}", small, large) + problems.see(places_of({low})));
}

void sizes(const Section& powder, ProblemList& problems) {
  const Section& size = powder.table("size");
  not_below(size, "smallest", "largest", problems);
  const Setting *diameters = size.find("diameters"), *shares = size.find("shares");
  if (diameters != nullptr) {
    for (std::size_t i = 1; i < diameters->numbers.size(); ++i) {
      if (diameters->numbers[i - 1] < diameters->numbers[i]) continue;
      problems.add(diameters->item_places[i], diameters->path + " is not ascending",
                   "expected each diameter above the one before");
      break;
    }
  }
  if (diameters != nullptr && shares != nullptr && diameters->numbers.size() != shares->numbers.size())
    problems.add(shares->place,
                 fmt::format("{} has {} elements, and {} diameters", shares->path, shares->numbers.size(),
                             diameters->numbers.size()),
                 "expected one share for each diameter");
  // Cut-offs that leave nothing of the distribution would make the draw of a size endless.
  const Setting *middle = size.find("diameter"), *low = size.find("smallest"), *high = size.find("largest");
  if (middle == nullptr || low == nullptr || high == nullptr || low->numbers[0] >= high->numbers[0]) return;
  if (middle->numbers[0] >= low->numbers[0] && middle->numbers[0] <= high->numbers[0]) return;
  problems.add(
      middle->place,
      fmt::format("{} is not between the cut-offs: {}", middle->path, length_text(middle->numbers[0])),
      fmt::format("expected {} to {}", length_text(low->numbers[0]), length_text(high->numbers[0])) +
          problems.see(places_of({low, high})));
}

// The table lists the sides of all shapes; each shape has its own.
void open_sides(const Section& wall, ProblemList& problems) {
  const Setting* open = wall.find("open");
  const std::string* shape = wall.optional_text("shape");
  if (open == nullptr || shape == nullptr || !open->given) return;
  for (std::size_t i = 0; i < open->texts.size(); ++i) {
    const bool of_round = open->texts[i] == "base" || open->texts[i] == "top";
    const bool round = *shape == "cylinder" || *shape == "cone";
    if (of_round == round) continue;
    problems.add(
        open->item_places[i], fmt::format("{}: a {} has no side \"{}\"", open->path, *shape, open->texts[i]),
        round ? "expected \"base\" or \"top\"" : "expected \"-x\", \"+x\", \"-y\", \"+y\", \"-z\" or \"+z\"");
  }
}

void what_is_measured(const Section& root, ProblemList& problems) {
  const Section& measures = root.table("measures");
  corners_in_order(measures.table("region"), problems);
  for (const Section& part : measures.group("parts")) corners_in_order(part, problems);
  const std::vector<std::size_t> inside = walls_with_inside(root);
  const auto& walls = root.group("walls");
  if (const Setting* die = measures.find("die")) {
    const auto wall = index_of(walls, die->texts.front());
    const std::string* shape = wall ? walls[*wall].optional_text("shape") : nullptr;
    if (shape != nullptr && *shape != "box" && *shape != "cylinder")
      problems.add(
          die->place,
          fmt::format("{}: \"{}\" is a {}, whose inside is not known", die->path, die->texts.front(), *shape),
          "expected a wall whose shape is \"box\" or \"cylinder\", or a table [measures.region]");
    return;
  }
  const bool wrong = measures.settings.contains("die");  // given, and reported elsewhere
  if (wrong || measures.table("region").given || inside.size() < 2) return;
  std::vector<std::string> names;
  for (const std::size_t wall : inside) names.push_back(walls[wall].name);
  problems.add(measures.place, "measures.die is missing: more than one wall has an inside",
               "expected die = " + enumerate(names));
}

// The largest parcel of all powders; nothing if some powder could not be read.
std::optional<double> largest_parcel(const Section& root) {
  double largest = 0.0;
  for (const Section& powder : root.group("powders")) {
    const Setting* factor = powder.find("coarse_graining");
    const Section& size = powder.table("size");
    const Setting *cut = size.find("largest"), *single = size.find("diameter"),
                  *table = size.find("diameters");
    const Setting* diameter = cut != nullptr ? cut : table != nullptr ? table : single;
    if (factor == nullptr || diameter == nullptr) return std::nullopt;
    largest = std::max(largest, factor->numbers.front() * diameter->numbers.back());
  }
  return largest > 0.0 ? std::optional(largest) : std::nullopt;
}

// Inner widths of a box or cylinder: along the axes, or across and along.
std::vector<std::pair<std::string, double>> inner_widths(const Section& wall) {
  std::vector<std::pair<std::string, double>> widths;
  const Setting *min = wall.find("min"), *max = wall.find("max");
  if (min != nullptr && max != nullptr)
    for (std::size_t axis = 0; axis < 3; ++axis)
      widths.emplace_back(fmt::format("along {}", axis_names[axis]), max->numbers[axis] - min->numbers[axis]);
  if (const Setting* radius = wall.find("radius"))
    widths.emplace_back("across", 2.0 * radius->numbers.front());
  if (const Setting* height = wall.find("height"))
    widths.emplace_back("along its axis", height->numbers.front());
  return widths;
}

// Where the widths of a wall and the sizes of parcels are written.
std::vector<Place> sizes_follow_from(const Section& root, const Section& wall) {
  std::vector<Place> places;
  for (const char* key : {"min", "max", "radius", "height"})
    if (wall.find(key) != nullptr && wall.find(key)->given) places.push_back(wall.find(key)->place);
  for (const Section& powder : root.group("powders")) {
    const auto sizes = places_in(powder.table("size"));
    places.insert(places.end(), sizes.begin(), sizes.end());
    if (powder.find("coarse_graining")->given) places.push_back(powder.find("coarse_graining")->place);
  }
  return places;
}

// In a die of less than three parcels there is nothing to measure, and powder arches at once.
void die_is_wide_enough(const Section& root, ProblemList& problems) {
  constexpr double least = 3.0;  // parcels
  const std::string* die = root.table("measures").optional_text("die");
  const auto parcel = largest_parcel(root);
  if (!parcel) return;
  for (const std::size_t index : walls_with_inside(root)) {
    const Section& wall = root.group("walls")[index];
    if (die != nullptr && wall.name != *die) continue;
    for (const auto& [direction, width] : inner_widths(wall)) {
      if (width >= least * *parcel || width <= 0.0) continue;
      problems.add(
          wall.place,
          fmt::format("{} is only {:.2g} parcels wide {}: {}, and the largest parcel is {}", wall.path,
                      width / *parcel, direction, length_text(width), length_text(*parcel)),
          "expected at least 3 parcels; lower coarse_graining or widen the die" +
              problems.see(sizes_follow_from(root, wall)));
    }
  }
}

// Whether parcels pass its openings is seen where those are known: see run/source_checks.
void sieve_is_whole(const Section& source, ProblemList& problems) {
  const bool has_pitch = source.settings.contains("sieve_pitch"),
             has_opening = source.settings.contains("sieve_opening");
  if (has_pitch != has_opening)
    return problems.add(
        source.place_of(has_pitch ? "sieve_pitch" : "sieve_opening"),
        fmt::format("{}.{} is missing", source.path, has_pitch ? "sieve_opening" : "sieve_pitch"),
        "expected both sieve_pitch and sieve_opening, or neither");
  const Setting *pitch = source.find("sieve_pitch"), *opening = source.find("sieve_opening");
  if (pitch == nullptr || opening == nullptr || opening->numbers[0] <= pitch->numbers[0]) return;
  problems.add(
      opening->place,
      fmt::format("{} is wider than the pitch: {} and {}", opening->path, length_text(opening->numbers[0]),
                  length_text(pitch->numbers[0])),
      fmt::format("expected at most {}", length_text(pitch->numbers[0])) + problems.see(places_of({pitch})));
}

void which_powder(const Section& root, ProblemList& problems) {
  const auto& powders = root.group("powders");
  if (powders.size() < 2) return;
  for (const Section& source : root.group("sources")) {
    if (source.settings.contains("powder")) continue;
    std::vector<std::string> names;
    for (const Section& powder : powders) names.push_back(powder.name);
    problems.add(source.place, source.path + ".powder is missing: there is more than one powder",
                 "expected powder = " + enumerate(names));
  }
}

}  // namespace

std::vector<std::size_t> walls_with_inside(const Section& root) {
  std::vector<std::size_t> result;
  const auto& walls = root.group("walls");
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (is_shape(walls[i], "box") || is_shape(walls[i], "cylinder")) result.push_back(i);
  return result;
}

void check_rules(const Section& root, ProblemList& problems) {
  corners_in_order(root.table("domain"), problems);
  pairs_once(root, problems);
  pairs_fit_the_law(root, problems);
  exponents_exist(root.table("contact"), problems);
  for (const Section& powder : root.group("powders")) sizes(powder, problems);
  for (const Section& wall : root.group("walls")) {
    corners_in_order(wall, problems);
    open_sides(wall, problems);
  }
  check_wall_rules(root, problems);
  for (const Section& source : root.group("sources")) {
    const Section& region = source.table("region");
    corners_in_order(region, problems);
    inside_domain(region, root.table("domain"), problems);
    sieve_is_whole(source, problems);
  }
  walls_fit_periodic_axes(root, problems);
  which_powder(root, problems);
  what_is_measured(root, problems);
  die_is_wide_enough(root, problems);
  check_shear_rules(root, problems);
  check_phase_rules(root, problems);
}

}  // namespace pulvis::case_file
