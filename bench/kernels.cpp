// SPDX-License-Identifier: Apache-2.0
// The parts of a step by themselves (Google Benchmark): kernels of some laws for each instruction set on a staged block,
// finding neighbours, carrying contacts over, and the ordered sums. kernels [--benchmark_filter=jkr]
#include <benchmark/benchmark.h>

#include <memory>
#include <numeric>

#include "engine/dynamics/integrate.hpp"
#include "validation/scene.hpp"

namespace {

using namespace pulvis;
using kernels::block_size;
using kernels::InstructionSet;

constexpr double radius = 0.00125, spacing = 1.98 * radius;  // m: neighbours overlap a little
constexpr double dt = 1e-5;                                  // s

struct NamedLaw {
  const char* name;
  scenes::Stuff stuff{};
  scenes::LawParts parts{};
};

std::vector<NamedLaw> some_laws() {
  std::vector<NamedLaw> list{{"hertz"}, {"jkr"}, {"sjkr"}, {"capillary_willett"}};
  for (NamedLaw& law : list) law.stuff.work_of_adhesion = 0.1;
  list[1].parts.normal = "jkr";
  list[2].parts.cohesion = "sjkr";
  list[2].stuff.cohesion_energy_density = 1e4;
  list[3].parts.cohesion = "capillary_willett";
  return list;
}

laws::MaterialPair material_of(const NamedLaw& law) {
  laws::MaterialPair pair = scenes::material_pair(law.stuff, law.stuff);
  pair.surface_tension = 0.07;
  pair.contact_angle = 0.3;
  pair.liquid_content = 1e-3;
  return pair;
}

/// A cubic lattice, each parcel with a small velocity and spin of its own.
Parcels lattice(std::uint32_t edge) {
  Parcels parcels;
  for (std::uint32_t id = 0; id < edge * edge * edge; ++id) {
    const Vec3 place{id % edge + 0.5, id / edge % edge + 0.5, id / (edge * edge) + 0.5};
    const auto [u, v, w] = uniform_triple(1, 0, id, 0);
    const Vec3 random{u - 0.5, v - 0.5, w - 0.5};
    parcels.body.push_back(scenes::parcel(id, spacing * place, radius, 2500.0, 0.02 * random, random));
    parcels.load.push_back({});
  }
  return parcels;
}

/// A block of contacts of neighbours, gathered, evaluated and scattered.
void kernel_of(benchmark::State& state, const NamedLaw& law, InstructionSet set) {
  const Parcels parcels = lattice(8);
  std::vector<std::uint32_t> first(block_size), second(block_size);
  for (std::uint32_t k = 0; k < block_size; ++k) {
    first[k] = k + k / 7;  // not the last of a row
    second[k] = first[k] + 1;
  }
  const laws::Law whole = scenes::law_of(law.parts);
  const laws::PairConstants constants = whole.mix(material_of(law), law.parts.choices);
  const kernels::ContactKernel kernel = kernels::contact_kernel(whole, set);
  auto block = std::make_unique<kernels::SeparateBlock>();
  std::vector<Load> loads(2 * block_size);
  std::vector<kernels::Places> places(block_size);
  for (std::uint32_t k = 0; k < block_size; ++k)
    places[k] = {2 * k * kernels::Places::numbers, (2 * k + 1) * kernels::Places::numbers};
  std::vector<std::uint8_t> touching(block_size, 1);
  for (auto _ : state) {
    kernel.gather(*block, parcels.body.data(), {block_size, first.data(), second.data(), touching.data(), 0});
    kernel.parcels(*block, constants.data(), dt);
    kernel.scatter(*block, places.data(), loads.data(), touching.data(), nullptr);
    benchmark::DoNotOptimize(loads.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * block_size);
}

/// A lattice with its lists, contacts of one law.
struct Bed {
  static constexpr std::uint32_t edge = 24;

  Bed() {
    classes.set(0, 0, scenes::contact_class(scenes::material_pair({}, {}), {}));
    box.max = edge * spacing * Vec3{1.0, 1.0, 1.0};
    box.periodic[0] = box.periodic[1] = box.periodic[2] = true;
    find();
    walls.rebuild({parcels, no_walls, {}, margin, crowd, {}, {}, 0.0, 0.0}, 1);
  }
  void find() { pairs.rebuild({parcels, classes, margin, 0.0, box, {}}, 1); }

  Parcels parcels = lattice(edge);
  std::vector<double> margin = std::vector<double>(parcels.size(), 0.05 * radius);
  std::vector<Vec3> reference = std::vector<Vec3>(parcels.size());
  std::vector<std::uint8_t> crowd = std::vector<std::uint8_t>(parcels.size(), 0);
  Leeway leeway() { return {reference.data(), margin.data(), crowd.data()}; }
  ContactClasses classes{1};
  Box box;
  Walls no_walls;
  NearPairs pairs;
  NearWalls walls;
};

void find_neighbours(benchmark::State& state) {
  Bed bed;
  for (auto _ : state) bed.find();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.parcels.size()));
}

void carry_contacts_over(benchmark::State& state) {
  Bed bed;
  std::fill(bed.pairs.touching.begin(), bed.pairs.touching.end(), std::uint8_t{1});
  std::vector<std::uint32_t> same(bed.parcels.size());
  std::iota(same.begin(), same.end(), 0u);
  for (auto _ : state) {
    const TouchingList list = bed.pairs.pack(bed.parcels, 1);
    benchmark::DoNotOptimize(bed.pairs.restore(list, same, bed.parcels, 1));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.parcels.size()));
}

/// A sweep over all pairs; `without_law`: the ordered sums and the motion alone.
void sweep_over_pairs(benchmark::State& state, bool without_law) {
  Bed bed;
  std::vector<ContactClass> one = bed.classes.all();
  if (without_law) {
    one[0].kernel = {};
    one[0].kernel.gather = [](kernels::ContactBlock&, const Parcel*, const kernels::SomePairs&) {};
    one[0].kernel.geometry = [](kernels::ContactBlock&, const double*, double) {};
    one[0].kernel.glance = [](const kernels::SomePairs&, const Parcel*, const Images&, double,
                              std::uint8_t*) { return 0; };
    one[0].kernel.any_in_reach = [](const kernels::ContactBlock&, double) { return false; };
  }
  ContactClasses classes(1);
  classes.set(0, 0, one[0]);
  ContactEvaluator evaluator(1, 1, 0.0);
  const Images images = Images::of(bed.box, 0.0);
  for (auto _ : state)
    sweep({bed.parcels, bed.pairs, bed.walls, evaluator, classes, images, bed.leeway()}, {{}, dt}, nullptr);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.parcels.size()));
}

}  // namespace

int main(int argc, char** argv) {
  // The sets up to the best of this processor.
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (set <= kernels::instruction_set())
      for (const NamedLaw& law : some_laws())
        benchmark::RegisterBenchmark(
            (std::string("kernel/") + law.name + "/" + kernels::name_of(set)).c_str(), kernel_of, law, set);
  benchmark::RegisterBenchmark("near_lists/find", find_neighbours);
  benchmark::RegisterBenchmark("near_lists/carry_over", carry_contacts_over);
  benchmark::RegisterBenchmark("sweep/sums_and_motion", sweep_over_pairs, true);
  benchmark::RegisterBenchmark("sweep/hertz", sweep_over_pairs, false);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
