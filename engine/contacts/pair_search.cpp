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
  std::uint32_t index;
  std::uint32_t species : 24;
  std::uint32_t crowd : 1;
  std::uint32_t looks_far : 1;  ///< beyond the cells around its own
};

/// How far to look. Cells are as wide as most parcels need, since each looks into all around its own; the few that reach
/// farther look farther.
struct Distances {
  double edge;      ///< m, of cells
  double farthest;  ///< m, between centres
};

Distances distances(const PairSearch& wanted) {
  const std::vector<Parcel>& body = wanted.parcels.body;
  const std::size_t count = body.size();
  double widest = 0.0;
  for (std::size_t k = 0; k < count; ++k) widest = std::max(widest, body[k].radius + wanted.margin[k]);
  const double farthest = 2.0 * widest + wanted.reach;
  if (wanted.slide.any() || count == 0) return {farthest, farthest};
  constexpr std::size_t enough = 512;
  std::vector<double> sample;
  for (std::size_t k = 0; k < count; k += 1 + count / enough)
    sample.push_back(body[k].radius + wanted.margin[k]);
  const auto most = sample.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(sample.size()));
  std::nth_element(sample.begin(), most, sample.end());
  const double edge = std::max(2.0 * *most + wanted.reach, 1.01 * farthest / CellGrid::farthest);
  return {edge > 0.9 * farthest ? farthest : edge, farthest};
}

/// In the order of the cells, so that a scan reads memory forwards.
std::vector<Candidate> in_order(const CellGrid& grid, const PairSearch& wanted, const Distances& far,
                                int threads) {
  const auto order = grid.order();
  std::vector<Candidate> candidates(order.size());
  parallel_shares(order.size(), threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t k = from; k < to; ++k) {
      const Parcel& p = wanted.parcels.body[order[k]];
      const double m = wanted.margin[order[k]], reach = p.radius + m;
      candidates[k] = {p.position,
                       reach,
                       p.radius + close_share * m,
                       order[k],
                       p.species & 0xffffffu,
                       wanted.crowd_of(order[k]) != 0,
                       2.0 * reach + wanted.reach > far.edge};
    }
  });
  return candidates;
}

/// `group` holds twice the partner's species, and whether they are apart.
void put_group(FoundPair& pair, std::uint32_t species, const ContactClasses& classes) {
  pair.group = classes.index(species, pair.group >> 1) +
               (pair.group & 1u) * static_cast<std::uint32_t>(classes.all().size());
}

/// Looks from candidates at those of their crowd: in the cells around at those behind them in the order, so that each pair is
/// found once (that needs cells that are near each other to be so from either side); beyond, see `compare`.
class Looker {
 public:
  Looker(const CellGrid& grid, const PairSearch& wanted, std::span<const Candidate> candidates,
         double farthest)
      : grid_(grid),
        wanted_(wanted),
        candidates_(candidates),
        farthest_(farthest),
        nearest_{NearestImage::of(wanted.box), wanted.slide} {}

  /// The pairs of the candidates [from, to).
  std::vector<FoundPair> look(std::size_t from, std::size_t to) {
    found_.reserve(4 * (to - from));
    for (std::size_t k = from; k < to;) {
      const std::size_t cell = grid_.cell_of(candidates_[k].index);
      ranges_.clear();
      ranges_beyond_.clear();
      const bool any_looks_far = std::any_of(&candidates_[k], &candidates_[0] + grid_.begin(cell + 1),
                                             [](const Candidate& c) { return c.looks_far; });
      if (any_looks_far)
        grid_.for_ranges_beyond(cell, farthest_, [&](std::uint32_t first, std::uint32_t last) {
          if (first < last) ranges_beyond_.push_back({first, last});
        });
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
      if (last > k + 1) compare<false>(k, own, std::max<std::size_t>(first, k + 1), last);
    if (own.looks_far)
      for (const auto& [first, last] : ranges_beyond_) compare<true>(k, own, first, last);
    for (std::size_t n = before; n < count_; ++n) put_group(found_[n], own.species, wanted_.classes);
  }

  /// With `far` of those that look as far only the ones behind: they find the others themselves.
  template <bool far>
  void compare(std::size_t own_place, const Candidate& own, std::size_t first, std::size_t last) {
    if (found_.size() < count_ + (last - first))
      found_.resize(found_.size() + found_.size() / 2 + (last - first));
    // Every one is written and most are overwritten: nobody can guess which candidates are near.
    FoundPair* const found = found_.data();
    std::size_t count = count_;
    for (std::size_t k = first; k < last; ++k) {
      const Candidate& c = candidates_[k];
      const Vec3 d = nearest_(c.position - own.position);
      const double wide = own.reach + c.reach + wanted_.reach, close = own.close + c.close + wanted_.reach;
      const double square = dot(d, d);
      const auto apart = static_cast<std::uint32_t>(!(square < close * close));
      found[count] = {own.index, c.index, 2 * c.species + apart};  // the group is made of it later
      bool is_near = (square < wide * wide) & (c.crowd == own.crowd);
      if constexpr (far) is_near &= !c.looks_far || k > own_place;
      count += static_cast<std::size_t>(is_near);
    }
    count_ = count;
  }

  const CellGrid& grid_;
  const PairSearch& wanted_;
  std::span<const Candidate> candidates_;
  double farthest_;
  Images nearest_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_, ranges_beyond_;
  std::vector<FoundPair> found_;
  std::size_t count_ = 0;
};

/// Pairs of a parcel of the second crowd and one of the first: a few, where one comes down on the other.
std::vector<FoundPair> find_between(const PairSearch& wanted, double farthest, int threads) {
  const std::vector<Parcel>& body = wanted.parcels.body;
  std::vector<std::uint32_t> first_crowd;
  for (std::uint32_t k = 0; k < body.size(); ++k)
    if (wanted.crowd_of(k) == 0) first_crowd.push_back(k);
  if (first_crowd.size() == body.size()) return {};  // the second is a body
  CellGrid grid;
  grid.build(wanted.box, farthest + wanted.between_crowds, first_crowd.size(),
             [&](std::size_t k) { return body[first_crowd[k]].position; });
  const NearestImage nearest = NearestImage::of(wanted.box);
  std::vector<std::vector<FoundPair>> of_thread(static_cast<std::size_t>(std::max(threads, 1)));
  parallel_shares(body.size(), threads, [&](std::size_t from, std::size_t to, int thread) {
    std::vector<FoundPair>& found = of_thread[static_cast<std::size_t>(thread)];
    const auto compare = [&](std::uint32_t own, std::uint32_t other) {
      const Parcel &p = body[own], &q = body[other];
      const Vec3 d = nearest(q.position - p.position);
      const double radii = p.radius + q.radius + wanted.reach,
                   margins = wanted.margin[own] + wanted.margin[other];
      const double wide = radii + margins + wanted.between_crowds, close = radii + close_share * margins;
      if (!(dot(d, d) < wide * wide)) return;
      found.push_back({own, other, 2 * q.species + static_cast<std::uint32_t>(!(dot(d, d) < close * close))});
      put_group(found.back(), p.species, wanted.classes);
    };
    for (std::size_t k = from; k < to; ++k) {
      if (wanted.crowd_of(k) == 0) continue;
      grid.for_ranges_around(grid.cell_at(body[k].position), [&](std::uint32_t first, std::uint32_t last) {
        for (; first < last; ++first)
          compare(static_cast<std::uint32_t>(k), first_crowd[grid.order()[first]]);
      });
    }
  });
  for (std::size_t t = 1; t < of_thread.size(); ++t)
    of_thread[0].insert(of_thread[0].end(), of_thread[t].begin(), of_thread[t].end());
  return std::move(of_thread[0]);
}

}  // namespace

std::vector<FoundPair> find_pairs(const PairSearch& wanted, int threads) {
  const std::vector<Parcel>& body = wanted.parcels.body;
  const Distances far = distances(wanted);
  CellGrid grid;
  grid.build(wanted.box, far.edge, body.size(), [&](std::size_t k) { return body[k].position; });
  const std::vector<Candidate> candidates = in_order(grid, wanted, far, threads);

  std::vector<std::vector<FoundPair>> of_thread(static_cast<std::size_t>(std::max(threads, 1)));
  parallel_shares(body.size(), threads, [&](std::size_t from, std::size_t to, int thread) {
    of_thread[static_cast<std::size_t>(thread)] =
        Looker(grid, wanted, candidates, far.farthest).look(from, to);
  });
  if (wanted.between_crowds > 0.0) of_thread.push_back(find_between(wanted, far.farthest, threads));
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
