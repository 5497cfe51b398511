// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "engine/laws/catalogue.hpp"

// One contact by itself, along its normal: two spheres, or a sphere at a flat wall, and the law between them.
// Whatever is said about it is asked of the law (Law::evaluate); no formula of any law stands here.
namespace pulvis::single_contact {

/// Sizes and masses of the two bodies; a wall has zeros.
struct Bodies {
  double radius_first = 0.0, radius_second = 0.0;  ///< m
  double mass_first = 0.0, mass_second = 0.0;      ///< kg
};

class Contact {
 public:
  Contact(const laws::Law& law, const laws::MaterialPair& material, const laws::Choices& choices,
          const Bodies& bodies);

  /// The same without what dissipates by speed: no dashpot, no viscosity of a liquid.
  Contact undamped() const;

  double radius() const { return radius_; }  ///< R*, m
  double mass() const { return mass_; }      ///< m*, kg
  double largest_sphere() const;             ///< m
  /// Whether the force depends on how deep the contact was before.
  bool remembers() const { return law_.normal->remembers; }
  /// Whether it takes energy by speed: a dashpot, or the viscosity of a liquid.
  bool is_damped() const;

  /// Gap at which a contact begins on approach, and up to which it then lasts, m.
  double formation_gap() const { return formation_; }
  double separation_gap() const { return separation_; }

  /// The law in motion: `closing` is the closing speed in the middle of the step that ends here, m/s.
  laws::Response in_motion(double overlap, double closing, bool was_touching, const laws::Past& past,
                           double dt) const;
  /// Force of a contact that approaches slowly for the first time, N; positive pushes apart.
  double pressing(double overlap) const;
  /// What it remembers then.
  laws::Past pressed_to(double overlap) const;
  /// Force of a contact that remembers `past` and comes back slowly, N; 0 once it is broken.
  double unloading(double overlap, const laws::Past& past) const;

  /// The overlap to which a slow force presses a new contact, m; with force 0 the one in which it rests under
  /// its own attraction. Nothing if it is drawn in to the radius of the larger sphere without finding hold.
  std::optional<double> overlap_under(double force) const;

 private:
  laws::Law law_;
  laws::MaterialPair material_;
  laws::Choices choices_;
  Bodies bodies_;
  laws::PairConstants constants_;
  double radius_, mass_, formation_, separation_;
};

/// Force of a response on the first body along the normal, N; positive pushes apart. The normal is z.
inline double push(const laws::Response& response) { return -response.force.z; }

}  // namespace pulvis::single_contact
