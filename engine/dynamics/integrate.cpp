// SPDX-License-Identifier: Apache-2.0
#include "engine/dynamics/integrate.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

/// Half a step of the velocities under the present load.
PULVIS_INLINE void kick(Parcel& p, const Load& load, double half_dt) {
  p.velocity += (half_dt / p.mass) * load.force;
  p.spin += (half_dt / inertia(p)) * load.torque;
}

/// Half a step that begins with the velocities seen from a rotating frame.
PULVIS_INLINE void kick_rotating_first(Parcel& p, const Load& load, const ForceField& field, double half_dt) {
  const Vec3 by_frame =
      -2.0 * cross(field.spin, p.velocity) - cross(field.spin_rate, p.position - field.point);
  const Vec3 turning = -cross(field.spin, p.spin) - field.spin_rate;
  kick(p, load, half_dt);
  p.velocity += half_dt * by_frame;
  p.spin += half_dt * turning;
}

/// The x of x + w x x = b (with the cross product of w).
PULVIS_INLINE Vec3 solve_turning(const Vec3& w, const Vec3& b) {
  return (b - cross(w, b) + dot(w, b) * w) / (1.0 + dot(w, w));
}

/// Half a step that ends with them.
PULVIS_INLINE void kick_rotating_last(Parcel& p, const Load& load, const ForceField& field, double half_dt) {
  kick(p, load, half_dt);
  const Vec3 euler = -cross(field.spin_rate, p.position - field.point);
  p.velocity = solve_turning((2.0 * half_dt) * field.spin, p.velocity + half_dt * euler);
  p.spin = solve_turning(half_dt * field.spin, p.spin - half_dt * field.spin_rate);
}

/// Moves a coordinate that left a periodic axis back by one length, and its reference with it; true if it did.
PULVIS_INLINE bool wrap(double& x, double& reference, double low, double high) {
  const double length = x >= high ? high - low : x < low ? low - high : 0.0;
  if (length == 0.0) return false;
  x -= length;
  reference -= length;
  return true;
}

/// Brings a parcel that left a sheared box across the gradient axis back as its image, and its reference with it.
PULVIS_INLINE void slide_back(Parcel& p, Vec3& reference, const Box& box, const Slide& slide) {
  const double x = p.position[slide.gradient];
  const double out = x >= box.max[slide.gradient] ? 1.0 : x < box.min[slide.gradient] ? -1.0 : 0.0;
  if (out == 0.0) return;
  p.position[slide.gradient] -= out * slide.height;
  p.position[slide.flow] -= out * slide.shift;
  p.velocity[slide.flow] -= out * slide.jump;
  reference[slide.gradient] -= out * slide.height;
  reference[slide.flow] -= out * slide.shift;
}

/// What is left of a parcel's margin at a strain since the lists were made. A strain e shortens no distance r by more
/// than e r/2 (the smaller stretch of a simple shear is sqrt(1 + e^2/4) - e/2), and pairs that are not listed were
/// farther apart than both radii, both margins and the reach: each parcel answers for half of it.
PULVIS_INLINE double margin_left(double margin, double radius, const ShearedStep& shear) {
  return margin - 0.5 * magnitude(shear.strain) * (radius + margin + 0.5 * shear.reach);
}

/// False also where a coordinate is not a number.
PULVIS_INLINE bool inside(const Vec3& x, const Box& box) {
  return x.x >= box.min.x && x.x <= box.max.x && x.y >= box.min.y && x.y <= box.max.y && x.z >= box.min.z &&
         x.z <= box.max.z;
}

/// The first half of a step for one parcel, `load` being what acts on it at the beginning.
PULVIS_INLINE void begin_one(std::size_t i, Parcels& parcels, const Load& load, const StepBeginning& b,
                             const Leeway& leeway, StepNotice& notice) {
  Parcel& p = parcels.body[i];
  Vec3& reference = leeway.reference[i];
  double margin = leeway.margin[i];
  if (b.field.rotating)
    kick_rotating_first(p, load, b.field, 0.5 * b.dt);
  else
    kick(p, load, 0.5 * b.dt);
  Vec3 move = b.dt * p.velocity;
  p.position += move;
  if (b.shear.slide.any()) {
    const Vec3 with_flow = b.dt * b.box.flow_velocity(reference);
    reference += with_flow;
    move -= with_flow;
    margin = margin_left(margin, p.radius, b.shear);
    slide_back(p, reference, b.box, b.shear.slide);
  }
  if (b.any_periodic)
    for (int axis = 0; axis < 3; ++axis)
      if (b.box.periodic[axis])
        notice.wrapped |= wrap(p.position[axis], reference[axis], b.box.min[axis], b.box.max[axis]);
  const Vec3 since = p.position - reference - b.drift[leeway.crowd[i]];
  notice.outside |= !inside(p.position, b.box) || !(dot(p.spin, p.spin) < 1e300);
  notice.too_fast |= dot(move, move) > 0.25 * (p.radius * p.radius);
  if (dot(since, since) > margin * margin || margin < 0.0) notice.note_left(i, i + 1);
}

/// What walls do to parcel `i`, by surface, is added to `sum`.
PULVIS_INLINE void add_walls(std::size_t i, const NearWalls& walls, Load& sum) {
  for (std::uint32_t slot = walls.begin[i]; slot < walls.begin[i + 1]; ++slot) {
    if (!walls.touching[slot]) continue;
    sum.force += walls.load[slot].force;
    sum.torque += walls.load[slot].torque;
  }
}

StepNotice all_of(const std::vector<StepNotice>& notices) {
  StepNotice all;
  for (const auto& n : notices) {
    all.outside |= n.outside;
    all.too_fast |= n.too_fast;
    all.wrapped |= n.wrapped;
    all.note_left(n.left_from, n.left_to);
  }
  return all;
}

/// One share of a sweep.
class ShareOfSweep {
 public:
  ShareOfSweep(SweptThings& things, const SweepFields& fields, const StepBeginning* next, int part)
      : t_(things), fields_(fields), next_(next), part_(part) {
    if (next && !fields.end.rotating && !next->field.rotating && !next->shear.slide.any())
      plain_ = {next->box.min,
                next->box.max,
                {next->box.periodic[0], next->box.periodic[1], next->box.periodic[2]},
                fields.end.gravity,
                fields.dt,
                next->drift};
  }

  /// Evaluates blocks and finishes parcels in turn. A parcel is done with once the slots of all that stand before it
  /// in the store, and its own, are evaluated: nobody asks for its place or velocity after that.
  void run() {
    t_.pairs.go_through(
        part_, t_.evaluator.cursors(part_),
        [&](std::size_t group, std::size_t from, std::size_t to) {
          const ContactClass& contact = t_.classes.all()[t_.pairs.class_of(group)];
          const StepOfPairs step{t_.parcels, contact, t_.images, fields_.dt, part_};
          if (t_.pairs.are_apart(group))
            t_.evaluator.pairs_apart(t_.pairs, from, to, step);
          else
            t_.evaluator.pairs_close(t_.pairs, from, to, step);
        },
        [&](std::size_t begin, std::size_t end) { finish(begin, end); });
  }

  /// Parcels with contacts in several shares, once all of those are evaluated.
  void finish_divided() {
    const std::span<const std::uint32_t> all = t_.pairs.divided_ones(part_);
    for (std::size_t k = 0; k < all.size(); k += at_once)
      finish({std::min(at_once, all.size() - k), 0, &all[k]});
  }

  StepNotice notice;

 private:
  static constexpr std::size_t at_once = kernels::block_size;

  /// All of a range but the divided ones: what acts on those may be in the making.
  void finish(std::size_t begin, std::size_t end) {
    for (std::size_t from = begin, to = begin; from < end; from = to) {
      const std::size_t most = std::min(end, from + at_once);
      to = t_.pairs.shares() == 1 ? most : from;
      while (to < most && !t_.pairs.divided(to)) ++to;
      if (to == from)
        ++to;
      else
        finish({to - from, from});
    }
  }

  /// Pairs that do not touch add zeros, which change no bit of a sum that began with +0: so most of them can be left out.
  void finish(const kernels::SomeParcels& some) {
    t_.evaluator.sum_close(t_.pairs, some, sums_);
    if (any_meets(some))
      for (std::size_t k = 0; k < some.count; ++k) {
        std::uint8_t& meets = t_.pairs.meets[some[k]];
        if (meets)
          sums_[k] = t_.evaluator.sum_all(t_.pairs, t_.parcels, static_cast<std::uint32_t>(some[k])),
          meets = 0;
      }
    if (some.list || t_.walls.begin[some.first] != t_.walls.begin[some.first + some.count])
      for (std::size_t k = 0; k < some.count; ++k) add_walls(some[k], t_.walls, sums_[k]);
    if (plain_)
      t_.evaluator.move()(*plain_, some, sums_, t_.parcels.body.data(), t_.leeway, notice);
    else
      for (std::size_t k = 0; k < some.count; ++k) finish(some[k], sums_[k]);
  }

  /// Most blocks have none: they are asked all at once.
  bool any_meets(const kernels::SomeParcels& some) const {
    if (some.list) return true;
    const std::uint8_t* const meets = &t_.pairs.meets[some.first];
    std::uint8_t any = 0;
    for (std::size_t k = 0; k < some.count; ++k) any |= meets[k];
    return any != 0;
  }

  /// One parcel, `sum` being what acts on it but for body forces.
  void finish(std::size_t i, Load sum) {
    Parcel& p = t_.parcels.body[i];
    sum.force += p.mass * fields_.end.at(p.position);
    if (fields_.end.rotating)
      kick_rotating_last(p, sum, fields_.end, 0.5 * fields_.dt);
    else
      kick(p, sum, 0.5 * fields_.dt);
    if (next_)
      begin_one(i, t_.parcels, sum, *next_, t_.leeway, notice);
    else
      t_.parcels.load[i] = sum;
  }

  SweptThings& t_;
  const SweepFields& fields_;
  const StepBeginning* next_;
  /// Where there is one (in most steps), parcels are finished many at a time, which gives the same and is faster.
  std::optional<kernels::PlainStep> plain_;
  int part_;
  Load sums_[at_once];  ///< of those being finished
};

}  // namespace

StepNotice begin_step(Parcels& parcels, const StepBeginning& beginning, const Leeway& leeway, int threads) {
  std::vector<StepNotice> notices(static_cast<std::size_t>(threads < 1 ? 1 : threads));
  parallel_shares(parcels.size(), threads, [&](std::size_t from, std::size_t to, int thread) {
    StepNotice mine;
    for (std::size_t i = from; i < to; ++i) begin_one(i, parcels, parcels.load[i], beginning, leeway, mine);
    notices[static_cast<std::size_t>(thread)] = mine;
  });
  return all_of(notices);
}

StepNotice sweep(SweptThings things, const SweepFields& fields, const StepBeginning* next) {
  const int shares = things.pairs.shares();
  // Before all others, since they lie in no order of the parcels.
  if (things.pairs.slots() > things.pairs.first_late())
    parallel_parts(shares, [&](int part) {
      things.evaluator.pairs_late(
          things.pairs, things.classes,
          {things.parcels, things.classes.all().front(), things.images, fields.dt, part});
    });
  std::vector<StepNotice> notices(static_cast<std::size_t>(shares));
  parallel_parts(shares, [&](int part) {
    ShareOfSweep share(things, fields, next, part);
    share.run();
    notices[static_cast<std::size_t>(part)] = share.notice;
  });
  if (shares == 1) return notices[0];
  parallel_parts(shares, [&](int part) {
    ShareOfSweep share(things, fields, next, part);
    share.notice = notices[static_cast<std::size_t>(part)];
    share.finish_divided();
    notices[static_cast<std::size_t>(part)] = share.notice;
  });
  return all_of(notices);
}

}  // namespace pulvis
