// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/body_force.hpp"
#include "engine/math/region.hpp"
#include "engine/math/vec3.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/walls/motions/motion.hpp"

// What a case file says, in SI units and checked: every number is in its range, every name refers to
// something that exists. `read_case` (reader.hpp) makes it; nothing below this line knows of TOML.
namespace pulvis {

/// Material of a powder or a wall. `*_coefficient` values are those against itself; see `Mixing`.
struct Material {
  std::string name;
  double density = 0.0;           ///< kg/m^3
  double young_modulus = 0.0;     ///< Pa
  double poisson_ratio = 0.0;     ///< -
  double surface_energy = 0.0;    ///< gamma of one surface, J/m^2
  double restitution = 0.0;       ///< coefficient of restitution, -
  double friction = 0.0;          ///< Coulomb coefficient, -
  double rolling_friction = 0.0;  ///< -
};

/// How the coefficients of two materials make that of the pair, where no pair states its own.
enum class Mixing { geometric_mean, arithmetic_mean, harmonic_mean, smaller, larger };

/// What a pair of materials states for itself, instead of the mixing rule.
struct PairOverride {
  std::size_t first = 0, second = 0;  ///< indices into Case::materials
  std::optional<double> restitution, friction, rolling_friction;
  std::optional<double> work_of_adhesion;  ///< W, J/m^2
  /// Numbers of the contact law, by the names they have in ContactChoice; SI, angles in rad.
  std::vector<std::pair<std::string, double>> numbers;
};

/// Distribution of grain diameters (of the real powder, before coarse graining).
struct SizeDistribution {
  enum class Kind { single, uniform, normal, lognormal, table };
  Kind kind = Kind::single;
  double diameter = 0.0;             ///< m; single: the diameter; normal: mean; lognormal: median (by number)
  double standard_deviation = 0.0;   ///< m; normal
  double geometric_deviation = 1.0;  ///< -; lognormal: exp(sigma of ln d)
  double smallest = 0.0;             ///< m; cut-off; uniform: lower end; single: the diameter
  double largest = 0.0;              ///< m; cut-off; uniform: upper end; single: the diameter
  bool by_mass = false;              ///< table: shares are mass fractions, not number fractions
  std::vector<double> diameters;     ///< m; table, ascending
  std::vector<double> shares;        ///< -; table, same length, positive, any sum
};

/// A powder: a material, a size distribution, and how it is represented.
struct Powder {
  enum class Keep { pull_off, sticking_speed };
  std::string name;
  std::size_t material = 0;                 ///< index into Case::materials
  SizeDistribution size;                    ///< of the real grains
  double coarse_graining = 1.0;             ///< alpha = parcel diameter / grain diameter, >= 1
  std::optional<double> simulated_modulus;  ///< Pa; softening: replaces Young's modulus of its material
  Keep keep = Keep::pull_off;               ///< which cohesion the softened powder preserves
};

/// Names of the contact law's parts and its named choices, text as in the catalogue of laws; and the numbers its
/// parts need, of grains, for all pairs that do not state their own (see laws::MaterialPair).
struct ContactChoice {
  std::string normal = "hertz", cohesion = "none", damping = "restitution", sliding = "total_spring";
  std::string rolling = "none", twisting = "none";
  std::string friction_limit = "elastic";      ///< elastic | total
  std::string cohesion_in_limit = "standard";  ///< standard | without | with | shifted
  std::string damping_radius = "hertz";        ///< hertz | jkr_radius
  std::string bridges_form = "touch";          ///< touch | approach
  std::string similarity = "stress";           ///< stress | bond | none: of parcels to grains
  bool tangential_damping = true;
  double normal_stiffness = 0.0, characteristic_speed = 0.0, tangential_ratio = 1.0;
  double plastic_ratio = 0.0, adhesion_ratio = 0.0, plasticity_depth = 0.0;
  double unloading_ratio = 0.0, constant_pull = 0.0;  ///< the pull is positive here
  double loading_exponent = 1.5, adhesion_exponent = 1.5;
  double cohesion_energy_density = 0.0;
  double surface_tension = 0.0, contact_angle = 0.0, liquid_content = 0.0, liquid_viscosity = 0.0;  ///< rad
  double shortest_bridge_gap = 0.01;
  double hamaker_constant = 0.0, shortest_gap = 0.0, longest_gap = 0.0;
  double rolling_viscosity = 0.0, twisting_friction = 0.0;
};

/// A wall. Which of the fields count depends on its shape.
struct Wall {
  enum class Shape { plane, rectangle, disc, box, cylinder, cone, sphere, mesh };
  std::string name;
  Shape shape = Shape::plane;
  std::size_t material = 0;          ///< index into Case::materials
  std::string body;                  ///< name of the rigid body it is part of; its own name if alone
  std::vector<std::size_t> motions;  ///< indices into Case::motions; none: at rest
  Vec3 point;                        ///< m; of the plane; corner, centre or base of others
  Vec3 normal{0, 0, 1};              ///< unit vector; plane, disc; of the cone, its axis
  Vec3 along, across;                ///< m; edges of the rectangle
  double radius = 0.0;               ///< m; disc, sphere, base of the cone
  double other_radius = 0.0;         ///< m; hole of the disc, top of the cone
  double height = 0.0;               ///< m; cone
  Region region;                     ///< box or cylinder
  std::vector<std::string> open;     ///< box: any of -x +x -y +y -z +z; cylinder, cone: any of base, top
  std::string path;                  ///< mesh: its STL file, made absolute
  double unit = 1.0;                 ///< mesh: m
  Vec3 offset;                       ///< mesh: m
  double feature_angle = 0.0;        ///< mesh: rad

  bool has_inside() const { return shape == Shape::box || shape == Shape::cylinder; }
};

/// A motion that walls can make; its time counts from the start of each phase that runs it.
struct Motion {
  std::string name;
  motions::Motion motion;
};

/// How much a source gives: a count or a mass, exactly one of them.
struct Target {
  std::optional<std::uint64_t> count;
  std::optional<double> mass;  ///< kg
};

/// Where parcels come from.
struct Source {
  enum class Kind { pack, dense, rain, file };
  std::string name;
  Kind kind = Kind::pack;
  std::size_t powder = 0;       ///< index into Case::powders
  Region region;                ///< pack, rain: where parcels appear, as a whole
  Target target;                ///< pack, rain
  double solid_fraction = 0.0;  ///< dense: of the whole domain
  double mass_rate = 0.0;       ///< kg/s; rain
  /// m; rain: between openings of a sieve, and their edge; both or none
  std::optional<double> sieve_pitch, sieve_opening;
  Vec3 velocity;     ///< m/s at insertion; pack, dense, rain
  std::string path;  ///< file: a LIGGGHTS/LAMMPS text dump; relative to the case file, made absolute
};

/// One phase of the procedure.
struct Phase {
  enum class Until { time, inserted, mass, cycles, motions, rest };
  std::string name;
  std::vector<std::size_t> sources;  ///< indices into Case::sources that are open in this phase
  std::vector<std::size_t> motions;  ///< indices into Case::motions that run in this phase
  std::vector<std::size_t> without;  ///< indices into Case::walls that are not there in this phase
  Until until = Until::time;
  double duration = 0.0;                 ///< s; until = time
  double mass = 0.0;                     ///< kg in the measured region; until = mass
  double cycles = 0.0;                   ///< -; until = cycles, of the first motion
  std::optional<double> kinetic_energy;  ///< translational, J per parcel; until = rest; default: 1e-3 of m g
                                         ///< d of the d50 parcel
  double at_least = 0.0;                 ///< s; the criterion is not asked before
  double time_limit = 0.0;               ///< s; required unless until is time or cycles
  bool limit_is_error = false;  ///< reaching the limit stops the run (exit 5) instead of ending the phase
};

struct Domain {
  Vec3 min, max;  ///< m
  bool periodic[3] = {false, false, false};
  Shear shear;
  bool escape_is_error = true;  ///< a parcel that leaves the domain or passes a wall stops the run
};

struct TimeChoice {
  double fraction = 0.2;                       ///< of the smallest limit
  std::optional<double> step;                  ///< s; fixed by the case
  std::optional<double> characteristic_speed;  ///< m/s, for the Hertz limit; default: estimated from the case
};

/// A part of the die that is measured by itself; in the die's own frame, from the lowest corner of its inside.
struct MeasuredPart {
  std::string name;
  Vec3 min, max;  ///< m
};

/// A disc or plane at rest, through which the flow of powder is measured.
struct FlowSurface {
  std::string name;
  Vec3 point;                    ///< m; its centre
  Vec3 normal;                   ///< unit vector; flow that way is positive
  std::optional<double> radius;  ///< m; without: it has no end
};

struct MeasureChoice {
  std::optional<std::size_t> die;  ///< index into Case::walls: the box or cylinder whose inside is measured
  std::optional<Region> region;    ///< instead of a die
  double cell_diameters = 3.0;     ///< edge of a porosity cell in mean parcel diameters
  std::optional<double> wall_window;  ///< s over which forces on walls are averaged
  double column_diameters = 2.0;      ///< edge of a free-surface column in mean parcel diameters
  double interval = 0.0;  ///< s between lines of measures.csv; 0: a hundredth of the longest phase
  bool energy_ledger = false;
  std::vector<MeasuredPart> parts;
  std::vector<FlowSurface> surfaces;
};

struct OutputChoice {
  double interval = 0.0;      ///< s between frames for ParaView; 0: only at the end of phases
  double log_interval = 0.0;  ///< s between lines of log.csv; 0: a hundredth of the longest phase limit
  double checkpoint_interval = 900.0;  ///< s on the clock; 0: only at the end of phases
  bool picture = true, report = true;
};

/// A key of a case with its value and where that comes from.
struct ResolvedKey {
  std::string key;        ///< "materials.steel.density"
  std::string value;      ///< as written in TOML
  std::string meaning;    ///< the same however it was written: numbers in SI units, all their digits
  std::string origin;     ///< "die.toml:14", "default" or "--set materials.steel.density"
  std::string comment{};  ///< at the end of that line; empty if there is none
};

struct Case {
  std::string title;
  std::string file;                ///< as given
  std::vector<std::string> bases;  ///< the files it extends, the nearest first
  /// For the run folder: the file's text; of a case that extends another, all its files put together, with paths
  /// made absolute.
  std::string text;
  std::vector<ResolvedKey> keys;  ///< every key that has a value, overrides and defaults too
  /// Where each table and key that was given is written: {"walls.die", "die.toml:14"} or {"time.step",
  /// "--set time.step"}; see place_of in reader.hpp.
  std::vector<std::pair<std::string, std::string>> origins;
  BodyForce body_force;
  Domain domain;
  Mixing mixing = Mixing::geometric_mean;
  std::vector<Material> materials;
  std::vector<PairOverride> pairs;
  std::vector<Powder> powders;
  ContactChoice contact;
  std::vector<Wall> walls;
  std::vector<Motion> motions;
  std::vector<Source> sources;
  std::vector<Phase> phases;
  TimeChoice time;
  MeasureChoice measures;
  OutputChoice output;
  std::uint64_t seed = 1;
};

}  // namespace pulvis
