// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <string_view>

#include "engine/kernels/contact_block.hpp"
#include "engine/kernels/energy_block.hpp"
#include "engine/kernels/parcel_block.hpp"

namespace pulvis::kernels {

namespace baseline {
ContactKernel contact_kernel(const laws::Law& law);
EnergyKernel energy_kernel(const laws::Law& law);
ParcelKernel parcel_kernel();
}  // namespace baseline
namespace avx2 {
ContactKernel contact_kernel(const laws::Law& law);
EnergyKernel energy_kernel(const laws::Law& law);
ParcelKernel parcel_kernel();
}  // namespace avx2
namespace avx512 {
ContactKernel contact_kernel(const laws::Law& law);
EnergyKernel energy_kernel(const laws::Law& law);
ParcelKernel parcel_kernel();
}  // namespace avx512

namespace {

InstructionSet best_of_processor() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

/// That of three which was compiled for this set.
template <class Thing>
Thing for_set(InstructionSet set, Thing baseline, Thing avx2, Thing avx512) {
  return set == InstructionSet::avx512 ? avx512 : set == InstructionSet::avx2 ? avx2 : baseline;
}

}  // namespace

InstructionSet instruction_set() {
  const InstructionSet best = best_of_processor();
  const char* wish = std::getenv("PULVIS_INSTRUCTION_SET");
  if (!wish) return best;
  const std::string_view text = wish;
  if (text == "baseline") return InstructionSet::baseline;
  if (text == "avx2" && best != InstructionSet::baseline) return InstructionSet::avx2;
  return best;
}

const char* name_of(InstructionSet set) { return for_set(set, "baseline", "avx2", "avx512"); }

ContactKernel contact_kernel(const laws::Law& law, InstructionSet set) {
  return for_set(set, baseline::contact_kernel, avx2::contact_kernel, avx512::contact_kernel)(law);
}
ParcelKernel parcel_kernel(InstructionSet set) {
  return for_set(set, baseline::parcel_kernel, avx2::parcel_kernel, avx512::parcel_kernel)();
}
EnergyKernel energy_kernel(const laws::Law& law, InstructionSet set) {
  return for_set(set, baseline::energy_kernel, avx2::energy_kernel, avx512::energy_kernel)(law);
}

}  // namespace pulvis::kernels
