// SPDX-License-Identifier: Apache-2.0
// A powder falls into a box and comes to rest: porosity and coordination number against the factor of coarse graining,
// figures 2.12 to 2.17 of G. Schiochet Nasato, Die filling of cohesive powders (JKU Linz, 2016), under each similarity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "run/assemble.hpp"
#include "run/pair_numbers.hpp"
#include "study/box_filling.hpp"
#include "study/cases.hpp"
#include "study/run_of_case.hpp"
#include "study/studies.hpp"

namespace pulvis::study {
namespace {

const std::vector<double> standard_factors{85, 120, 170}, quick_factors{120, 170};
constexpr double gravity = 9.81;

// Without cohesion there is nothing on which similarities could differ, and the number of SJKR2 is a stress: under
// stress similarity it stays as it is.
struct Series {
  const char *law, *case_file;
  std::vector<const char*> similarities;
  bool in_quick_form = false;
};
const Series series[] = {{"hertz", "box-filling.toml", {"stress"}, true},
                         {"hooke", "box-filling-hooke.toml", {"stress"}},
                         {"jkr", "box-filling-jkr.toml", {"bond", "stress", "none"}, true},
                         {"sjkr2", "box-filling-sjkr2.toml", {"bond", "stress"}},
                         {"capillary", "box-filling-capillary.toml", {"bond", "stress", "none"}}};

/// Coarse beds scatter more, for they have fewer parcels. Without cohesion small differences are judged: each factor has as
/// many parcels in all. Those between similarities are larger.
int seeds_at(const Series& s, double factor, double finest, int seeds) {
  const double power = s.similarities.size() == 1 ? 3.0 : 1.5;
  return static_cast<int>(std::lround(seeds * std::pow(factor / finest, power)));
}

std::vector<Point> points(const Options& options) {
  std::vector<double> factors = !options.factors.empty() ? options.factors
                                : options.quick          ? quick_factors
                                                         : standard_factors;
  std::sort(factors.begin(), factors.end());
  const int seeds = options.seeds > 0 ? options.seeds : options.quick ? 10 : 4;  // of the finest factor
  if (factors.size() < 2 || seeds < 2)
    throw Failure(Exit::usage,
                  "the study \"box-filling\" compares factors beyond the scatter of seeds: give at least "
                  "two --factors and two --seeds");
  std::vector<Point> list;
  for (const double factor : factors)
    for (const Series& s : series) {
      if (options.quick && !s.in_quick_form) continue;
      for (int seed = 1; seed <= seeds_at(s, factor, factors.front(), seeds); ++seed)
        for (const char* similarity : s.similarities)
          list.push_back({fmt::format("{}-{}-{:g}-seed-{}", s.law, similarity, factor, seed),
                          {{"law", s.law},
                           {"case", s.case_file},
                           {"similarity", similarity},
                           {"factor", factor},
                           {"seed", seed}}});
    }
  return list;
}

std::vector<Override> settings_of(const Json& settings) {
  return {{"powders.molybdenum.coarse_graining", fmt::format("{:.17g}", settings.at("factor").get<double>())},
          {"contact.similarity", "\"" + settings.at("similarity").get<std::string>() + "\""},
          {"seed", std::to_string(settings.at("seed").get<int>())}};
}

/// Pull-off force of two grains over their diameter squared, Pa.
double pull_of_grains(const Case& c) {
  const std::vector<Species> species = species_of(c);
  const PairNumbers n = pair_numbers(c, species, mix_pairs(c, species).front(), Scale::grain, 0.0, 0.1);
  return n.adhesion.pull_off / (4.0 * n.radius * n.radius);
}

Json measures_in(const std::string& file) {
  std::ifstream stream(file);
  Json measures = Json::parse(stream, nullptr, false);
  if (!measures.is_object()) throw Failure(Exit::bad_input, fmt::format("{}: cannot be read", file));
  return measures;
}

/// The layers of the bed, the lowest first, each with what lies on its middle.
Json layers_of(const Json& measures, double area) {
  struct Layer {
    std::string name;
    double low, high, mass;
    Json porosity, coordination;
  };
  std::vector<Layer> layers;
  double all = 0.0;
  for (const Json& part : measures.at("parts")) {
    const std::string name = part.at("name");
    if (!name.starts_with("slab-") || !part.at("mass_kg").is_number()) continue;
    layers.push_back({name, part.at("min_m").at(2), part.at("max_m").at(2), part.at("mass_kg"),
                      part.at("porosity"), part.at("coordination")});
    all += layers.back().mass;
  }
  std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.low < b.low; });
  Json list = Json::array();
  double below = 0.0;
  for (const Layer& l : layers) {
    if (l.porosity.is_number() && l.coordination.is_number())
      list.push_back({{"low_m", l.low},
                      {"high_m", l.high},
                      {"mass_kg", l.mass},
                      {"porosity", l.porosity},
                      {"coordination", l.coordination},
                      {"overburden_Pa", (all - below - 0.5 * l.mass) * gravity / area}});
    below += l.mass;
  }
  return list;
}

Json compute(const Work& work) {
  const std::string file = written_case(work.folder, work.settings.at("case"));
  const std::vector<Override> settings = settings_of(work.settings);
  const Json run = run_of_case(work, file, settings);
  const Case c = read_case(file, settings);
  const Json measures = measures_in(work.folder + "/run/measures/after-fill.json");
  const Vec3 size = c.domain.max - c.domain.min;
  const double surface = measures.at("surface").at("mean_m");
  const Json layers = layers_of(measures, size.x * size.y);
  double volume = 0.0, porosity = 0.0, mass = 0.0, coordination = 0.0;
  for (const Json& l : layers) {
    const double low = l.at("low_m"), high = l.at("high_m"), of_layer = l.at("mass_kg");
    if (low < end_layer - 1e-9 || high > surface - end_layer) continue;
    volume += high - low, porosity += (high - low) * l.at("porosity").get<double>();
    mass += of_layer, coordination += of_layer * l.at("coordination").get<double>();
  }
  if (volume == 0.0)
    throw Failure(Exit::internal_check,
                  "no layer of the bed is far enough from floor and surface to be judged");
  return {{"porosity", porosity / volume},
          {"coordination", coordination / mass},
          {"surface_m", surface},
          {"layers", layers},
          {"pull_of_grains_Pa", pull_of_grains(c)},
          {"parcels", run.at("particles")},
          {"steps", run.at("steps")},
          {"simulated_time_s", run.at("simulated_time_s")},
          {"seconds", run.at("stepping_time_s")}};
}

}  // namespace

Study box_filling() {
  return {"box-filling",
          "Filling a box with coarse-grained powder",
          "Parcels of molybdenum (grains of 4.6 um) fall into a box that is periodic along x and y and come "
          "to rest on "
          "its floor, in a bed of about 8 mm. Porosity and coordination number are those of layers of 1 mm, "
          "without the "
          "lowest 2 mm and those that reach into the highest 2 mm. Seeds give the scatter. Without cohesion "
          "nothing "
          "should depend on the factor. With it, numbers of the law that stay as they are (none) lose "
          "cohesion as "
          "parcels grow, and the bed packs too densely (not SJKR2, whose number is a stress: it is the same "
          "as under stress); those that keep pull-off force over weight (bond) "
          "gain strength, "
          "and it packs too loosely; under stress similarity the profile stays as it is at depths where what "
          "lies "
          "above exceeds three times the Rumpf strength (1 - porosity)/porosity F_po/d^2 (H. Rumpf, Chem. "
          "Ing. Tech. "
          "42 (1970) 538-540, doi:10.1002/cite.330420806).",
          false,
          points,
          compute,
          conclude_box_filling};
}

}  // namespace pulvis::study
