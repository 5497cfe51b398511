// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "case/keys.hpp"

// What the files of the key table share; only they include it.
namespace pulvis::case_file {

using Keys = std::vector<Key>;

inline constexpr Range positive{Range::End::excluded, Range::End::open, 0.0, 0.0};
inline constexpr Range not_negative{Range::End::included, Range::End::open, 0.0, 0.0};
inline constexpr Range fraction{Range::End::excluded, Range::End::included, 0.0, 1.0};

inline void append(Keys& keys, const Keys& more) { keys.insert(keys.end(), more.begin(), more.end()); }

/// Title, domain, gravity, materials, pairs, powders, contact law.
void append_matter(Keys& keys);

/// Of these, the contact law.
void append_contact(Keys& keys);

/// Walls, motions, sources, phases.
void append_process(Keys& keys);

/// Of these, the walls; and how they move.
void append_walls(Keys& keys);
void append_motions(Keys& keys);

/// A box or a cylinder, wherever a region is described.
void append_shape(Keys& keys, const std::string& table);

/// What is measured, and where.
void append_measures(Keys& keys);

/// Time step, measures, output.
void append_choices(Keys& keys);

}  // namespace pulvis::case_file
