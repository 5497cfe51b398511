// SPDX-License-Identifier: Apache-2.0
// Pairs that come near between two rebuilds of the lists.
#include <algorithm>

#include "engine/contacts/near_pairs.hpp"

namespace pulvis {

bool NearPairs::is_listed(std::uint32_t i, std::uint32_t j) const {
  for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
    if (partner(entry[k]) == j) return true;
  for (const Waiting& w : waiting_of(i))
    if (partner(w.entry) == j) return true;
  return false;
}

void NearPairs::add(std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs, const Parcels& parcels) {
  for (auto& [i, j] : pairs)
    if (parcels.body[i].id > parcels.body[j].id) std::swap(i, j);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::erase_if(pairs, [&](const auto& pair) { return is_listed(pair.first, pair.second); });
  const std::size_t waited = waiting_.size();
  for (const auto& [i, j] : pairs) {
    const auto slot = static_cast<std::uint32_t>(slots());
    first.push_back(i);
    second.push_back(j);
    touching.push_back(0);
    waiting_.push_back({i, parcels.body[j].id, 2 * slot});
    waiting_.push_back({j, parcels.body[i].id, 2 * slot + 1});
  }
  pasts.met.add(pairs.size());
  const auto middle = waiting_.begin() + static_cast<std::ptrdiff_t>(waited);
  std::sort(middle, waiting_.end());
  std::inplace_merge(waiting_.begin(), middle, waiting_.end());
}

std::span<const NearPairs::Waiting> NearPairs::waiting_of(std::uint32_t parcel) const {
  if (waiting_.empty()) return {};
  const auto [from, to] =
      std::equal_range(waiting_.begin(), waiting_.end(), Waiting{parcel, 0, 0},
                       [](const Waiting& a, const Waiting& b) { return a.parcel < b.parcel; });
  return {from, to};
}

/// One pass from the last parcel to the first: the entries of each go where they will stand.
void NearPairs::settle_late(const Parcels& parcels) {
  const auto partner_id = [&](std::uint32_t of_entry) { return parcels.body[partner(of_entry)].id; };
  std::size_t left = waiting_.size(), old_end = entry.size(),
              done = begin.size() - 1;  // parcels behind `done` are
  entry.resize(entry.size() + left);
  while (left > 0) {
    const std::uint32_t parcel = waiting_[left - 1].parcel;
    const std::size_t own = begin[parcel], behind = begin[parcel + 1];
    std::move_backward(entry.begin() + behind, entry.begin() + old_end, entry.begin() + old_end + left);
    for (std::size_t k = parcel + 1; k <= done; ++k) begin[k] += static_cast<std::uint32_t>(left);
    done = parcel;
    for (old_end = behind; left > 0 && waiting_[left - 1].parcel == parcel; --left) {
      for (; old_end > own && partner_id(entry[old_end - 1]) > waiting_[left - 1].partner_id; --old_end)
        entry[old_end - 1 + left] = entry[old_end - 1];
      entry[old_end + left - 1] = waiting_[left - 1].entry;
    }
  }
  waiting_.clear();
}

}  // namespace pulvis
