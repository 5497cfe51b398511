// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/contacts/energy_works.hpp"
#include "engine/simulation/model.hpp"
#include "engine/simulation/state.hpp"

namespace pulvis {

/// Where all energy is and where it came from and went, J, since the ledger began.
///   translational + rotational + potential + stored
///     = start + inserted - removed + brought_in - lost + closing_error
struct EnergyBalance {
  using Term = kernels::EnergyTerm;

  double translational = 0.0, rotational = 0.0;
  double potential =
      0.0;  ///< -sum m g . x where gravity is the only body force, constant, across no periodic face
  std::array<double, kernels::energy_terms> of{};
  double start = 0.0, inserted = 0.0, removed = 0.0;
  double body_forces = 0.0;     ///< their work, where they have no potential
  bool has_potential = true;    ///< else the line above counts
  bool splits_contacts = true;  ///< every law of the model states what it stores

  double operator[](Term t) const { return of[static_cast<std::size_t>(t)]; }
  double kinetic() const { return translational + rotational; }
  double stored() const { return sum(Term::elastic, Term::twisting_spring); }
  /// All that forces took, the limits of springs too; touch and separation.
  double lost() const {
    return sum(Term::normal_dashpot, Term::unsplit_friction) + sum(Term::sliding, Term::forgotten_springs);
  }
  double brought_in() const {
    return body_forces + (*this)[Term::walls] + sum(Term::sliding_stiffness, Term::changed_contacts);
  }
  double closing_error() const {
    return kinetic() + potential + stored() - (start + inserted - removed + brought_in() - lost());
  }
  /// What became of the energy so far: lost, or in motion and contacts now. It depends on no choice of zero of the
  /// potential, and leaves out what went to and fro.
  double put_through() const;
  /// closing_error over put_through, 0 where nothing was.
  double closing_share() const;

 private:
  double sum(Term first, Term last) const {
    double all = 0.0;
    for (auto t = static_cast<std::size_t>(first); t <= static_cast<std::size_t>(last); ++t) all += of[t];
    return all;
  }
};

/// Keeps the EnergyAccount of a state. NOTATION.md, "Energy ledger", has the theory.
class EnergyLedger {
 public:
  EnergyLedger(const Model& model, int most_threads);

  /// Begins the account, if it has not begun.
  void begin(EnergyAccount& account, const ContactView& view, const ForceField& field);

  void before_contacts(const NearPairs& pairs, const NearWalls& walls) {
    works_.before_contacts(pairs, walls);
  }
  void before_kick(const Parcels& parcels) { works_.before_kick(parcels); }
  /// `field` is that of the end of the step.
  void after_step(EnergyAccount& account, const ContactView& view, const ForceField& field);

  void insert(EnergyAccount& account, const Parcel& parcel, const ForceField& field) const;
  /// A parcel leaves with the velocity it has in the middle of a step, at the place it has there.
  void remove(EnergyAccount& account, const Parcel& parcel, const Vec3& place) const;
  /// What contacts store, to be asked before and after some are taken away with a parcel or a body.
  double stored(const ContactView& view) { return works_.stored(view); }

  EnergyBalance balance(const EnergyAccount& account, const Parcels& parcels) const;

 private:
  double potential(const Parcel& p, const Vec3& place) const;
  Quanta work_of_body_forces(const ContactView& view, const ForceField& field);

  Vec3 gravity_;
  double dt_;
  bool has_potential_;
  SumGrid grid_;
  EnergyWorks works_;
  std::vector<Quanta> shares_;  ///< per thread
};

}  // namespace pulvis
