// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as contact_kernels.cpp: between the store of parcels and the lanes of a block. Records
// are read and written whole and turned into lanes in registers (engine/math/four.hpp).
#include "engine/kernels/parcel_block.hpp"
#include "engine/math/four.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

/// The records of the pairs k to k + 3; of what is left over, those of the last repeat.
struct FourPairs {
  PULVIS_INLINE FourPairs(const SomePairs& pairs, const Parcel* parcels, int k) {
    for (int j = 0; j < 4; ++j) put(pairs, parcels, j, k + j);
  }
  PULVIS_INLINE static FourPairs at_the_end(const SomePairs& pairs, const Parcel* parcels, int k) {
    FourPairs four;
    for (int j = 0; j < 4; ++j) four.put(pairs, parcels, j, k + j < pairs.count ? k + j : pairs.count - 1);
    return four;
  }
  const double *first[4], *second[4];

 private:
  PULVIS_INLINE FourPairs() : first(), second() {}
  PULVIS_INLINE void put(const SomePairs& pairs, const Parcel* parcels, int j, int lane) {
    first[j] = &parcels[pairs.first[lane]].position.x;
    second[j] = &parcels[pairs.second[lane]].position.x;
  }
};

PULVIS_INLINE void put_offsets(Lanes3& offset, int k, Quartet first_at, Quartet second_at) {
  put_four(offset.x + k, second_at.a - first_at.a);
  put_four(offset.y + k, second_at.b - first_at.b);
  put_four(offset.z + k, second_at.c - first_at.c);
}

PULVIS_INLINE void gather_four(ContactBlock& b, int k, const FourPairs& of) {
  const Quartet p_at = quartet(of.first, 0), q_at = quartet(of.second, 0);
  put_offsets(b.offset, k, p_at, q_at);
  put_four(b.radius_first + k, p_at.d);
  put_four(b.radius_second + k, q_at.d);
  const Quartet p_speed = quartet(of.first, 4), q_speed = quartet(of.second, 4);
  put_four(b.velocity.x + k, p_speed.a - q_speed.a);
  put_four(b.velocity.y + k, p_speed.b - q_speed.b);
  put_four(b.velocity.z + k, p_speed.c - q_speed.c);
  put_four(b.mass_first + k, p_speed.d);
  put_four(b.mass_second + k, q_speed.d);
  // The fourth of these are ids, which nobody asks for.
  const Quartet p_spin = quartet(of.first, 8), q_spin = quartet(of.second, 8);
  put_four(b.spin_first.x + k, p_spin.a);
  put_four(b.spin_first.y + k, p_spin.b);
  put_four(b.spin_first.z + k, p_spin.c);
  put_four(b.spin_second.x + k, q_spin.a);
  put_four(b.spin_second.y + k, q_spin.b);
  put_four(b.spin_second.z + k, q_spin.c);
}

static void gather(ContactBlock& b, const Parcel* parcels, const SomePairs& given) {
  const SomePairs pairs = given;
  const int count = pairs.count;
  b.count = count;
  // What the next block needs lies all over the store.
#pragma GCC unroll 4
  for (int k = block_size; k < block_size + pairs.ahead; ++k) {
    ask_for(parcels[pairs.first[k]]);
    ask_for(parcels[pairs.second[k]]);
  }
#pragma omp simd
  for (int k = 0; k < count; ++k) b.touching[k] = pairs.touching[k];
  int k = 0;
  for (; k + 4 <= count; k += 4) gather_four(b, k, FourPairs(pairs, parcels, k));
  if (k < count) gather_four(b, k, FourPairs::at_the_end(pairs, parcels, k));
}

/// The loads on the parcels of the contacts k to k + 3.
static void scatter_four(const ContactBlock& b, int k, const Places* places, double* load) {
  double *first[4], *second[4];
  for (int j = 0; j < 4; ++j) {
    first[j] = load + places[k + j].first;
    second[j] = load + places[k + j].second;
  }
  const Four x = four_at(b.force.x + k), y = four_at(b.force.y + k), z = four_at(b.force.z + k);
  put_quartet(first, 0, {x, y, z, four_at(b.torque_first.x + k)});
  put_quartet(second, 0, {-x, -y, -z, four_at(b.torque_second.x + k)});
  Quartet rest{four_at(b.torque_first.y + k), four_at(b.torque_first.z + k), four_at(b.torque_second.y + k),
               four_at(b.torque_second.z + k)};
  transpose(rest.a, rest.b, rest.c, rest.d);
  const Four rows[4] = {rest.a, rest.b, rest.c, rest.d};
  for (int j = 0; j < 4; ++j)
    put_two(first[j] + 4, first_two(rows[j])), put_two(second[j] + 4, last_two(rows[j]));
}

static void scatter(const ContactBlock& b, const Places* places, Load* loads, std::uint8_t* touching,
                    Vec3* force) {
  const int count = b.count;
  double* const load = &loads->force.x;
  int k = 0;
  for (; k + 4 <= count; k += 4) scatter_four(b, k, places, load);
  for (; k < count; ++k) {
    const Vec3 on_first = kernels::load(b.force, k);
    loads[places[k].first / Places::numbers] = {on_first, kernels::load(b.torque_first, k)};
    loads[places[k].second / Places::numbers] = {-on_first, kernels::load(b.torque_second, k)};
  }
#pragma omp simd
  for (k = 0; k < count; ++k) touching[k] = b.touching[k] > 0.5;
  if (!force) return;
  for (k = 0; k < count; ++k) force[k] = kernels::load(b.force, k);
}

/// Where the second of a pair lies from the first, and the sum of their radii.
struct Distances {
  Lanes3 offset;
  alignas(64) Lane radii;
};

PULVIS_INLINE void put_distances(Distances& b, int k, const FourPairs& of) {
  const Quartet p_at = quartet(of.first, 0), q_at = quartet(of.second, 0);
  put_offsets(b.offset, k, p_at, q_at);
  put_four(b.radii + k, q_at.d + p_at.d);
}

static void read_distances(Distances& b, const SomePairs& pairs, const Parcel* parcels) {
  for (int k = pairs.count; k < pairs.count + pairs.ahead; ++k) {
    __builtin_prefetch(&parcels[pairs.first[k]].position);
    __builtin_prefetch(&parcels[pairs.second[k]].position);
  }
  int k = 0;
  for (; k + 4 <= pairs.count; k += 4) put_distances(b, k, FourPairs(pairs, parcels, k));
  if (k < pairs.count) put_distances(b, k, FourPairs::at_the_end(pairs, parcels, k));
}

static int glance(const SomePairs& given, const Parcel* parcels, const Images& images, double approach,
                  std::uint8_t* met) {
  constexpr double roundings = 1.0 + 1e-12;  // of a distance here and in the law
  const SomePairs pairs = given;
  Distances b;
  read_distances(b, pairs, parcels);
  if (images.slide.any())
    for (int k = 0; k < pairs.count; ++k) store(b.offset, k, images.slide(load(b.offset, k)));
  const NearestImage nearest = images.periods;
  alignas(64) Lane is_met;
  double any = 0.0;
#pragma omp simd reduction(+ : any)
  for (int k = 0; k < pairs.count; ++k) {
    const Vec3 offset = nearest(load(b.offset, k));
    const double reach = roundings * (b.radii[k] + approach);
    const double near = select(dot(offset, offset) < reach * reach, 1.0, 0.0);
    is_met[k] = near;
    any += near;
  }
  std::uint8_t held = 0;
  for (int k = 0; k < pairs.count; ++k) held |= pairs.touching[k];
  if (any == 0.0 && held == 0) return 0;
  int count = 0;
  for (int k = 0; k < pairs.count;
       ++k) {  // each is written and most are overwritten: nobody can guess which are met
    met[count] = static_cast<std::uint8_t>(k);
    count += (is_met[k] != 0.0) | (pairs.touching[k] != 0);
  }
  return count;
}

void add_exchange(ContactKernel& kernel) {
  kernel.gather = gather;
  kernel.glance = glance;
  kernel.scatter = scatter;
}

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
