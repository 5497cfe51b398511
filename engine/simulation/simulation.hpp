// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "engine/base/time_sheet.hpp"
#include "engine/contacts/evaluate.hpp"
#include "engine/contacts/late_search.hpp"
#include "engine/contacts/near_pairs.hpp"
#include "engine/contacts/near_walls.hpp"
#include "engine/dynamics/integrate.hpp"
#include "engine/simulation/energy_ledger.hpp"
#include "engine/simulation/model.hpp"
#include "engine/simulation/state.hpp"

namespace pulvis {

/// The engine: a model, its state, and what is derived from them to go fast. The state after n steps does not
/// depend on the number of threads, the instruction set, the skin, or on having been saved and loaded.
class Simulation {
 public:
  /// What comes after a step.
  enum class Then {
    look,   ///< anything
    go_on,  ///< the next step, before anybody looks at parcels or loads
  };

  /// Books its time on `times`, which may have begun before.
  Simulation(Model model, State state, int threads, const TimeSheet& times = {});

  /// Fresh state for a model: no parcels, all at rest.
  static State initial_state(const Model& model);

  /// One time step. Throws Failure(physics) where it cannot go on: a number that is not one, a parcel or a wall
  /// that moved more than half a radius; and, looked for every 64 steps, parcels that overlap too deeply. Parcels that
  /// escape are taken out, counted, and in `escapes`.
  /// With Then::go_on parcels may have gone on with the next step already, which is faster: until that is made, ask for
  /// nothing but step, time, escapes and the number of parcels. A step in which parcels escape is always whole. Forces
  /// between parcels are there after Then::look only.
  void step(Then then = Then::look);
  /// Whether a source may give parcels in the next step.
  bool a_source_is_due() const;

  void open_source(std::size_t source);
  void close_source(std::size_t source);
  void start_motion(std::size_t motion);
  void stop_motion(std::size_t motion);
  /// Takes a body away or puts it back where its motions have it now. Throws Failure(physics) if parcels are
  /// where it appears.
  void set_absent(std::size_t body, bool absent);

  /// Throws Failure(physics) naming the first parcel whose numbers are none. A step looks at what the one before it
  /// made; this looks at what the last one made.
  void require_finite() const;
  /// The same, and for parcels that overlap by more than the model allows.
  void require_sound() const;

  State snapshot() const;
  /// state_hash of the snapshot, without making one.
  std::string hash() const;
  const Model& model() const { return model_; }
  const State& state() const { return state_; }  ///< without `pairs` and `walls`: see `snapshot`
  State& state() { return state_; }
  const NearPairs& pairs() const { return pairs_; }
  const NearWalls& walls() const { return walls_; }
  double time() const { return static_cast<double>(state_.step) * model_.dt; }
  const Pose& pose(std::size_t body) const { return poses_[body]; }
  /// Where periodic images are at the end of the step.
  const Images& images() const { return images_; }
  /// Body forces at the end of the step.
  ForceField field() const { return model_.body_force.at(time()); }
  /// Threads in use: no more than are worth waking for so many parcels.
  int threads() const;
  int most_threads() const { return most_threads_; }
  std::uint64_t rebuilds() const { return rebuilds_; }
  /// How often a parcel that left its margin was looked from alone.
  std::uint64_t relisted() const { return relisted_; }
  /// Where the time went; whoever leads the simulation books his own there too. No bit of the state knows of it.
  const TimeSheet& times() const { return times_; }
  TimeSheet& times() { return times_; }

  /// Where all energy is and went; empty unless the model asks for the ledger.
  std::optional<EnergyBalance> energy() const;

  /// Force of all parcels on a surface, N, summed in order of ids.
  Vec3 force_on_surface(std::size_t surface) const;
  /// Slots of walls() in the order of the parcels' ids, surfaces ascending: sums that go through it do not
  /// depend on how the store is sorted. Made anew at each rebuild.
  const std::vector<std::uint32_t>& wall_slots_by_id() const { return wall_slots_by_id_; }

  /// Bytes held by the arrays that grow with the number of parcels.
  std::size_t memory() const;
  /// What a program needs at its peak for a dense bed; `pulvis bench` measures it.
  static constexpr double peak_bytes_per_parcel = 1000.0;

 private:
  /// Body forces now, for the half step that ends or began `steps` from now.
  ForceField field_towards(double steps) const {
    return model_.body_force.at(time(), time() + steps * model_.dt);
  }
  Slide slide_at(std::uint64_t step) const {
    return Slide::of(model_.domain, static_cast<double>(step) * model_.dt);
  }
  ShearedStep shear_to_next_step() const;
  StepBeginning beginning() const {
    return {model_.domain, field_towards(0.5), model_.dt, drifted(model_.dt), shear_to_next_step()};
  }
  void require_whole_step() const;
  void insert_due_parcels();
  bool clear_of_walls(const Vec3& centre, double radius) const;
  void move_bodies_to(std::uint64_t step);
  Rigid placement(std::size_t body, std::uint64_t step) const;
  /// Drifts when `time` more has passed, s.
  Drift drifted(double time) const {
    return {{drift_[0] + time * drift_velocity_[0], drift_[1] + time * drift_velocity_[1]}};
  }
  Leeway leeway() { return {reference_.data(), margin_.data(), crowd_.data()}; }
  bool find_two_crowds(double far);
  void choose_crowds(std::span<const std::uint32_t> old_index);
  /// How much nearer crowds may come from now on, m.
  double between_crowds_left() const { return between_crowds_ - norm(drift_[1] - drift_[0]); }
  bool crowds_have_parted() const { return between_crowds_left() < 0.0; }
  double speed_against(const Vec3& velocity, std::size_t body) const;
  void find_body_corners();
  TouchingList without_body(const TouchingList& list, std::size_t body) const;
  void require_nothing_inside(std::size_t body) const;
  void sort_wall_slots();
  void take_out_escaped(const StepNotice& notice);
  void take_out_crossed();
  void require_shallow() const;
  void require_slow_walls() const;
  /// What a parcel touches, and by which law: for messages.
  std::string surroundings_of(std::size_t parcel) const;
  /// When parcels leave, velocities are those of the middle of a step that moved them, or of its end.
  enum class Velocities { of_middle, of_end };
  void remove(std::vector<std::uint32_t>& indices, Velocities velocities);
  ContactView view() const;
  void before_contacts();
  void account_energy();
  void account_leaving(const Parcel& parcel, const Load& load, Velocities velocities);
  [[noreturn]] void fail_at(const char* what, const char* remedy, const Parcel& parcel) const;

  /// Rebuilds the near lists and carries the contacts over. `old_index` as in NearPairs::restore.
  /// Returns where each parcel of the store as it is now stood before.
  std::vector<std::uint32_t> rebuild(const TouchingList& old_pairs, const TouchingList& old_walls,
                                     std::vector<std::uint32_t> old_index);
  void rebuild();
  /// 0, 1, 2... : the index of each parcel where the store keeps its order.
  static std::vector<std::uint32_t> same_order(std::size_t count);
  std::vector<double> expected_speeds(std::span<const std::uint32_t> old_index) const;
  void choose_margins(std::span<const std::uint32_t> old_index);
  static constexpr double steps_between_rebuilds = 60.0;  ///< what the margins of moving parcels aim at
  double margin_for(double speed, double radius) const;
  double widest_margin() const { return greatest(0.6 * model_.skin, 0.5); }  ///< radii
  bool a_body_left_its_margin() const;
  bool relist_those_that_left();
  double speed_around(std::uint32_t parcel) const;
  std::uint8_t nearer_crowd(const Vec3& velocity) const;
  WallSearch wall_search() const {
    return {state_.parcels, model_.walls, poses_, margin_,        crowd_,
            body_margin_,   body_crowd_,  reach_, between_crowds_};
  }
  void sort_along_space(std::vector<std::uint32_t>& old_index);

  Model model_;
  State state_;
  int most_threads_;
  TimeSheet times_;
  Images images_;
  double reach_ = 0.0;
  std::vector<Pose> poses_;
  NearPairs pairs_;
  NearWalls walls_;
  ContactEvaluator evaluator_;
  std::optional<EnergyLedger> energy_;
  std::vector<Pose> next_poses_;  ///< of the step that comes; only for the ledger of energy
  /// m/s that each crowd had at the last rebuild, and m it made since by it.
  kernels::OfCrowds drift_velocity_{};
  Drift drift_{};
  double between_crowds_ = 0.0;  ///< m they may make against each other until the lists are made again
  std::vector<std::uint8_t> crowd_, body_crowd_;  ///< of each parcel and body
  std::vector<Vec3> reference_;        ///< positions when it was listed last, less its crowd's drift
  std::vector<Rigid> body_reference_;  ///< placements at the last rebuild
  std::vector<std::array<Vec3, 8>> body_corners_;  ///< of a box around what parcels can touch, its own frame
  std::vector<std::uint32_t> wall_slots_by_id_;
  bool has_bounded_walls_ = false;
  bool walls_may_be_left_ = false;   ///< contacts with walls may end without their law in this rebuild
  std::vector<double> margin_;       ///< m per parcel
  std::vector<double> body_margin_;  ///< m per body
  std::vector<Crossing> crossings_;
  StepNotice notice_;   ///< of the first half of a step
  bool ahead_ = false;  ///< the first half of the next step is made
  LateSearch late_search_;
  std::uint64_t relisted_ = 0;
  std::uint64_t rebuilds_ = 0;
  std::uint64_t rebuilt_at_ = 0, sorted_at_ = 0;  ///< steps
};

}  // namespace pulvis
