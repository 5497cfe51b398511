// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as contact_kernels.cpp: between the store of parcels and the lanes of a block. Records
// are read and written whole and turned into lanes in registers (engine/math/four.hpp).
#include "engine/kernels/parcel_block.hpp"
#include "engine/math/four.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

/// The records of the pairs k to k + 3 of `count`; what is left over repeats the last.
struct FourPairs {
  [[gnu::always_inline]] FourPairs(const Parcel* parcels, const std::uint32_t* firsts,
                                   const std::uint32_t* seconds, int k, int count) {
    for (int j = 0; j < 4; ++j) {
      const int lane = k + j < count ? k + j : count - 1;
      first[j] = reinterpret_cast<const double*>(parcels + firsts[lane]);
      second[j] = reinterpret_cast<const double*>(parcels + seconds[lane]);
    }
  }
  const double *first[4], *second[4];
};

PULVIS_INLINE void put_offsets(Lanes3& offset, int k, Quartet first_at, Quartet second_at) {
  put_four(offset.x + k, second_at.a - first_at.a);
  put_four(offset.y + k, second_at.b - first_at.b);
  put_four(offset.z + k, second_at.c - first_at.c);
}

static void gather(ContactBlock& b, const Parcel* parcels, const std::uint32_t* first,
                   const std::uint32_t* second, int ahead) {
  const int count = b.count;
  for (int k = block_size; k < block_size + ahead;
       ++k) {  // what the next block needs lies all over the store
    ask_for(parcels[first[k]]);
    ask_for(parcels[second[k]]);
  }
  for (int k = 0; k < count; k += 4) {
    const FourPairs of(parcels, first, second, k, count);
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
}

static void scatter(const ContactBlock& b, PairLoad* load, const std::uint32_t* place, Vec3* force) {
  int k = 0;
  for (; k + 4 <= b.count; k += 4) {
    double* to[4];
    for (int j = 0; j < 4; ++j) to[j] = &load[place[k + j]].force.x;
    put_quartet(to, 0,
                {four_at(b.force.x + k), four_at(b.force.y + k), four_at(b.force.z + k),
                 four_at(b.torque_first.x + k)});
    put_quartet(to, 4,
                {four_at(b.torque_first.y + k), four_at(b.torque_first.z + k), four_at(b.torque_second.x + k),
                 four_at(b.torque_second.y + k)});
    for (int j = 0; j < 4; ++j) to[j][8] = b.torque_second.z[k + j];
  }
  for (; k < b.count; ++k)
    load[place[k]] = {kernels::load(b.force, k), kernels::load(b.torque_first, k),
                      kernels::load(b.torque_second, k)};
  if (!force) return;
  for (k = 0; k < b.count; ++k) force[k] = kernels::load(b.force, k);
}

/// Where the second of a pair lies from the first, and the sum of their radii.
struct Distances {
  Lanes3 offset;
  alignas(64) Lane radii;
};

static void read_distances(Distances& b, const PairsApart& pairs, const Parcel* parcels) {
  for (int k = pairs.count; k < pairs.count + pairs.ahead; ++k) {
    __builtin_prefetch(&parcels[pairs.first[k]].position);
    __builtin_prefetch(&parcels[pairs.second[k]].position);
  }
  for (int k = 0; k < pairs.count; k += 4) {
    const FourPairs of(parcels, pairs.first, pairs.second, k, pairs.count);
    const Quartet p_at = quartet(of.first, 0), q_at = quartet(of.second, 0);
    put_offsets(b.offset, k, p_at, q_at);
    put_four(b.radii + k, q_at.d + p_at.d);
  }
}

static int glance(const PairsApart& given, const Parcel* parcels, const Images& images, double approach,
                  std::uint8_t* met) {
  constexpr double roundings = 1.0 + 1e-12;  // of a distance here and in the law
  const PairsApart pairs = given;
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
