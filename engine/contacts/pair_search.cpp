// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/pair_search.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/parallel.hpp"
#include "engine/contacts/cell_grid.hpp"

namespace pulvis {
namespace {

// Pairs closer than this share of their margins when the lists are made are expected to touch before the next time.
constexpr double close_share = 0.1;

struct Candidate {
  Vec3 position;
  double reach;  ///< radius + margin
  double close;  ///< radius + its share of the margin
  std::uint32_t index, species;
};

/// In the order of the cells, so that a scan reads memory forwards.
std::vector<Candidate> in_order(const CellGrid& grid, const PairSearch& wanted, int threads) {
  const auto order = grid.order();
  std::vector<Candidate> candidates(order.size());
  parallel_shares(order.size(), threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t k = from; k < to; ++k) {
      const Parcel& p = wanted.parcels.body[order[k]];
      const double m = wanted.margin[order[k]];
      candidates[k] = {p.position, p.radius + m, p.radius + close_share * m, order[k], p.species};
    }
  });
  return candidates;
}

/// Looks from candidates at those behind them in the order, so that each pair is found once. That needs cells that are near
/// each other to be so from either side.
class Looker {
 public:
  Looker(const CellGrid& grid, const PairSearch& wanted, std::span<const Candidate> candidates)
      : grid_(grid),
        wanted_(wanted),
        candidates_(candidates),
        nearest_{NearestImage::of(wanted.box), wanted.slide} {}

  /// The pairs of the candidates [from, to).
  std::vector<FoundPair> look(std::size_t from, std::size_t to) {
    found_.reserve(4 * (to - from));
    for (std::size_t k = from; k < to;) {
      const std::size_t cell = grid_.cell_of(candidates_[k].index);
      ranges_.clear();
      grid_.for_ranges_around(cell, wanted_.slide, [&](std::uint32_t first, std::uint32_t last) {
        ranges_.push_back({first, last});
      });
      for (const std::size_t end = std::min<std::size_t>(grid_.begin(cell + 1), to); k < end; ++k)
        look_from(k);
    }
    found_.resize(count_);
    return std::move(found_);
  }

 private:
  void look_from(std::size_t k) {
    const Candidate own = candidates_[k];
    const std::size_t before = count_;
    for (const auto& [first, last] : ranges_)
      if (last > k + 1) compare(own, std::max<std::size_t>(first, k + 1), last);
    const auto classes = static_cast<std::uint32_t>(wanted_.classes.all().size());
    for (std::size_t n = before; n < count_; ++n) {
      std::uint32_t& group = found_[n].group;
      group = wanted_.classes.index(own.species, group >> 1) + (group & 1u) * classes;
    }
  }

  void compare(const Candidate& own, std::size_t first, std::size_t last) {
    if (found_.size() < count_ + (last - first))
      found_.resize(found_.size() + found_.size() / 2 + (last - first));
    // Every one is written and most are overwritten: nobody can guess which candidates are near.
    FoundPair* const found = found_.data();
    std::size_t count = count_;
    for (std::size_t k = first; k < last; ++k) {
      const Candidate& c = candidates_[k];
      const Vec3 d = nearest_(c.position - own.position);
      const double far = own.reach + c.reach + wanted_.reach, close = own.close + c.close + wanted_.reach;
      const double square = dot(d, d);
      const auto apart = static_cast<std::uint32_t>(!(square < close * close));
      found[count] = {own.index, c.index, 2 * c.species + apart};  // the group is made of it later
      count += static_cast<std::size_t>(square < far * far);
    }
    count_ = count;
  }

  const CellGrid& grid_;
  const PairSearch& wanted_;
  std::span<const Candidate> candidates_;
  Images nearest_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_;
  std::vector<FoundPair> found_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<FoundPair> find_pairs(const PairSearch& wanted, int threads) {
  const std::vector<Parcel>& body = wanted.parcels.body;
  double widest = 0.0;
  for (std::size_t k = 0; k < body.size(); ++k) widest = std::max(widest, body[k].radius + wanted.margin[k]);
  CellGrid grid;
  grid.build(wanted.box, 2.0 * widest + wanted.reach, body.size(),
             [&](std::size_t k) { return body[k].position; });
  const std::vector<Candidate> candidates = in_order(grid, wanted, threads);

  std::vector<std::vector<FoundPair>> of_thread(static_cast<std::size_t>(std::max(threads, 1)));
  parallel_shares(body.size(), threads, [&](std::size_t from, std::size_t to, int thread) {
    of_thread[static_cast<std::size_t>(thread)] = Looker(grid, wanted, candidates).look(from, to);
  });
  std::size_t total = 0;
  for (const auto& found : of_thread) total += found.size();
  std::vector<FoundPair> all = std::move(of_thread[0]);
  all.reserve(total);
  for (std::size_t t = 1; t < of_thread.size(); ++t) {
    all.insert(all.end(), of_thread[t].begin(), of_thread[t].end());
    std::vector<FoundPair>().swap(of_thread[t]);
  }
  return all;
}

}  // namespace pulvis
