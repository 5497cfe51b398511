// SPDX-License-Identifier: Apache-2.0
// Memory in large blocks comes from the system and goes back to it at once, and has pages of 2 MiB.
//
// Contacts read parcels all over the store. With pages of 4 KiB most of those reads must look the page up first, once the
// store is larger than what the processor keeps of its page table: on a bed of 90,000 a step took 1.45 times as long. And the
// lists, which are made anew with other sizes now and then, would leave the heap in pieces: it grew to four times what is
// in use. Sanitizers bring operators of their own, and do without.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>

namespace {

constexpr std::size_t page = std::size_t{2} << 20, large = page / 2;

// A threshold that is set does not grow, as glibc's own does with each block that is freed. Smaller blocks stay with us when
// they are free: to get pages of 4 KiB from the system again at each rebuild of the lists takes longer than to write them.
[[maybe_unused]] const int thresholds = mallopt(M_MMAP_THRESHOLD, static_cast<int>(large)) &
                                        mallopt(M_TRIM_THRESHOLD, 16 * static_cast<int>(page));

void* allocate(std::size_t size, std::size_t alignment) {
  if (size > PTRDIFF_MAX) throw std::bad_alloc();
  if (size >= page) alignment = std::max(alignment, page);
  void* block =
      std::aligned_alloc(alignment, (std::max(size, std::size_t{1}) + alignment - 1) / alignment * alignment);
  if (!block) throw std::bad_alloc();
  if (size >= page) madvise(block, size, MADV_HUGEPAGE);  // a wish: small pages do as well
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  if (size >= page) return allocate(size, page);
  if (void* block = std::malloc(std::max(size, std::size_t{1}))) return block;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }
#endif
