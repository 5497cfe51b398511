// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/kernels/contact_block.hpp"
#include "engine/laws/catalogue.hpp"

namespace pulvis {

/// A law with the constants of one pair of species, ready to run.
struct ContactClass {
  laws::Law law;
  laws::PairConstants constants{};
  kernels::ContactKernel kernel{};
};

/// The contact class of every two species: powders and the materials of walls alike.
class ContactClasses {
 public:
  ContactClasses() = default;
  explicit ContactClasses(std::size_t species) : species_(species), index_(species * species, 0) {}

  /// Sets the class of two species, in either order.
  void set(std::size_t a, std::size_t b, const ContactClass& contact) {
    index_[a * species_ + b] = index_[b * species_ + a] = static_cast<std::uint32_t>(classes_.size());
    classes_.push_back(contact);
  }
  std::uint32_t index(std::uint32_t a, std::uint32_t b) const { return index_[a * species_ + b]; }
  const std::vector<ContactClass>& all() const { return classes_; }
  std::size_t species() const { return species_; }

  /// Whether the contacts of any class need a memory besides their springs.
  bool remember() const {
    for (const auto& c : classes_)
      if (c.law.remembers()) return true;
    return false;
  }
  /// Widest gap, m, at which any contact can begin on approach; 0 for most laws.
  double longest_approach(double radius) const {
    double gap = 0.0;
    for (const auto& c : classes_) gap = greatest(gap, c.law.formation_gap(radius, c.constants));
    return gap;
  }
  /// Largest gap, m, to which any contact can stretch if no reduced radius exceeds `radius`.
  double longest_reach(double radius) const {
    double reach = 0.0;
    for (const auto& c : classes_) reach = greatest(reach, c.law.separation_gap(radius, c.constants));
    return reach;
  }

 private:
  std::size_t species_ = 0;
  std::vector<std::uint32_t> index_;
  std::vector<ContactClass> classes_;
};

}  // namespace pulvis
