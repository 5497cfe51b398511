// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "case/key_rows.hpp"

// The part of the key table on the contact law: which parts it is made of, and the numbers they need. Names are
// those of the catalogue in engine/laws.
namespace pulvis::case_file {
namespace {

using enum KeyKind;
using enum Presence;

void append_parts(Keys& keys) {
  append(keys,
         {
             {.pattern = "contact",
              .kind = table,
              .help = "the parts of the contact law, between parcels and on walls"},
             {.pattern = "contact.normal",
              .kind = choice,
              .example = R"("jkr")",
              .standard = R"("hertz")",
              .choices = {"hertz", "jkr", "hooke", "luding", "edinburgh"},
              .help = "normal force: elastic spheres (hertz, hooke), elastic spheres that adhere (jkr), or "
                      "spheres that yield "
                      "and adhere (luding, edinburgh); see docs/laws.md"},
             {.pattern = "contact.cohesion",
              .kind = choice,
              .example = R"("sjkr")",
              .standard = R"("none")",
              .choices = {"none", "dmt", "sjkr", "sjkr2_reduced_radius", "sjkr2_twice_reduced_radius",
                          "capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                          "capillary_soulie", "hamaker"},
              .help = "attraction on hertz or hooke; the other normal laws have their own"},
             {.pattern = "contact.damping",
              .kind = choice,
              .example = R"("restitution")",
              .standard = R"("restitution")",
              .choices = {"restitution", "none"},
              .help = "normal dashpot: from the coefficient of restitution (Tsuji), or none"},
             {.pattern = "contact.sliding",
              .kind = choice,
              .example = R"("total_spring")",
              .standard = R"("total_spring")",
              .choices = {"total_spring", "incremental_spring", "rescaled_spring", "viscous", "none"},
              .help = "tangential force with Coulomb's limit: a spring in its total, incremental or rescaled "
                      "(Thornton) form, a "
                      "dashpot, or none"},
             {.pattern = "contact.tangential_damping",
              .kind = boolean,
              .example = "false",
              .standard = "true",
              .help = "whether the tangential force has a dashpot"},
             {.pattern = "contact.rolling",
              .kind = choice,
              .example = R"("elastic_plastic")",
              .standard = R"("none")",
              .choices = {"elastic_plastic", "elastic_plastic_viscous", "constant_torque", "none"},
              .help = "rolling resistance: elastic-plastic spring (EPSD2), the same with a viscous part "
                      "(EPSD), constant "
                      "directional torque (CDT), or none"},
             {.pattern = "contact.twisting",
              .kind = choice,
              .example = R"("elastic_plastic")",
              .standard = R"("none")",
              .choices = {"elastic_plastic", "none"},
              .help = "resistance to spin about the normal: elastic-plastic spring, or none"},
             {.pattern = "contact.similarity",
              .kind = choice,
              .example = R"("bond")",
              .standard = R"("stress")",
              .choices = {"stress", "bond", "none"},
              .help = "how the numbers of the law follow coarse_graining: stress keeps stresses, speeds and "
                      "overlaps over radii of the grains; bond differs in cohesion, which it rescales "
                      "further, so that pull-off force over weight is kept; none leaves each number as "
                      "it is for a grain"},
             {.pattern = "contact.friction_limit",
              .kind = choice,
              .example = R"("total")",
              .standard = R"("elastic")",
              .choices = {"elastic", "total"},
              .help = "normal force in the friction limits: without its dashpot, or with it (as LIGGGHTS)"},
             {.pattern = "contact.cohesion_in_limit",
              .kind = choice,
              .example = R"("with")",
              .standard = R"("standard")",
              .choices = {"standard", "without", "with", "shifted"},
              .help = "what cohesion does to that force: what the law's own page says, nothing, lowers it, "
                      "or lowers it and adds "
                      "twice the pull-off force"},
             {.pattern = "contact.damping_radius",
              .kind = choice,
              .example = R"("jkr_radius")",
              .standard = R"("hertz")",
              .choices = {"hertz", "jkr_radius"},
              .help = "stiffness that damping uses under JKR: Hertz's at the same overlap, or that of the "
                      "JKR contact radius"},
         });
}

void append_normal_numbers(Keys& keys) {
  append(keys,
         {
             {.pattern = "contact.normal_stiffness",
              .kind = quantity,
              .dimension = dimension::surface_energy,
              .example = R"("1 kN/m")",
              .when_unset = "from characteristic_speed",
              .range = positive,
              .only_when = {"normal", {"hooke", "luding"}},
              .help = "stiffness of a contact of grains; parcels take coarse_graining times it"},
             {.pattern = "contact.characteristic_speed",
              .kind = quantity,
              .dimension = dimension::speed,
              .example = R"("0.5 m/s")",
              .when_unset = "none: give normal_stiffness",
              .range = positive,
              .only_when = {"normal", {"hooke", "luding"}},
              .help = "speed of impact at which the largest overlap is that of Hertz"},
             {.pattern = "contact.tangential_ratio",
              .kind = number,
              .example = "0.8",
              .standard = "1",
              .range = {Range::End::included, Range::End::included, 0.0, 1.0},
              .only_when = {"normal", {"hooke", "luding"}},
              .help = "tangential over normal stiffness"},
             {.pattern = "contact.plastic_ratio",
              .kind = number,
              .example = "5",
              .presence = required,
              .range = {Range::End::included, Range::End::included, 1.001, 1e4},
              .only_when = {"normal", {"luding"}},
              .help = "largest unloading stiffness over the loading stiffness"},
             {.pattern = "contact.adhesion_ratio",
              .kind = number,
              .example = "0.5",
              .presence = required,
              .range = {Range::End::included, Range::End::included, 0.0, 1e4},
              .only_when = {"normal", {"luding"}},
              .help = "adhesive stiffness over the loading stiffness"},
             {.pattern = "contact.plasticity_depth",
              .kind = number,
              .example = "0.05",
              .presence = required,
              .range = {Range::End::included, Range::End::included, 1e-6, 1.0},
              .only_when = {"normal", {"luding"}},
              .help = "depth, over the radius, beyond which a contact no longer yields"},
             {.pattern = "contact.unloading_ratio",
              .kind = number,
              .example = "5",
              .presence = required,
              .range = {Range::End::included, Range::End::included, 1.001, 1e4},
              .only_when = {"normal", {"edinburgh"}},
              .help = "unloading over loading stiffness"},
             {.pattern = "contact.constant_pull",
              .kind = quantity,
              .dimension = dimension::force,
              .example = R"("1 nN")",
              .standard = R"("0 N")",
              .range = not_negative,
              .only_when = {"normal", {"edinburgh"}},
              .help = "constant attraction of two grains in contact; parcels take its coarse_graining^2"},
             {.pattern = "contact.loading_exponent",
              .kind = number,
              .example = "1",
              .standard = "1.5",
              .range = {Range::End::included, Range::End::included, 1.0, 1.5},
              .only_when = {"normal", {"edinburgh"}},
              .help = "exponent of the overlap in loading, 1 or 1.5"},
             {.pattern = "contact.adhesion_exponent",
              .kind = number,
              .example = "2",
              .standard = "1.5",
              .range = {Range::End::included, Range::End::included, 1.0, 2.0},
              .only_when = {"normal", {"edinburgh"}},
              .help = "exponent of the overlap in the adhesive branch, 1, 1.5 or 2"},
         });
}

void append_other_numbers(Keys& keys) {
  append(keys,
         {
             {.pattern = "contact.cohesion_energy_density",
              .kind = quantity,
              .dimension = dimension::pressure,
              .example = R"("50 kJ/m^3")",
              .presence = required,
              .range = not_negative,
              .only_when = {"cohesion", {"sjkr", "sjkr2_reduced_radius", "sjkr2_twice_reduced_radius"}},
              .help = "attraction over the contact area"},
             {.pattern = "contact.surface_tension",
              .kind = quantity,
              .dimension = dimension::surface_energy,
              .example = R"("72 mN/m")",
              .presence = required,
              .range = positive,
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "surface tension of the liquid"},
             {.pattern = "contact.contact_angle",
              .kind = quantity,
              .dimension = dimension::angle,
              .example = R"("10 deg")",
              .standard = R"("0 deg")",
              .range = {Range::End::included, Range::End::included, 0.0, 50.0 / 360.0},
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "angle of wetting"},
             {.pattern = "contact.liquid_content",
              .kind = number,
              .example = "1e-3",
              .presence = required,
              .range = {Range::End::included, Range::End::included, 1e-7, 0.5},
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "volume of a bridge over that of the two bodies it joins"},
             {.pattern = "contact.liquid_viscosity",
              .kind = quantity,
              .dimension = Dimension{1, -1, -1},
              .example = R"("1 mPa s")",
              .standard = R"("0 Pa s")",
              .range = not_negative,
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "dynamic viscosity of the liquid; 0: bridges do not damp"},
             {.pattern = "contact.shortest_bridge_gap",
              .kind = number,
              .example = "0.02",
              .standard = "0.01",
              .range = {Range::End::included, Range::End::included, 1e-6, 1.0},
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "smallest gap over the reduced radius in the viscous part, for roughness"},
             {.pattern = "contact.bridges_form",
              .kind = choice,
              .example = R"("approach")",
              .standard = R"("touch")",
              .choices = {"touch", "approach"},
              .only_when = {"cohesion",
                            {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                             "capillary_soulie"}},
              .help = "when bridges form: when the grains touch, or at the rupture distance on approach"},
             {.pattern = "contact.hamaker_constant",
              .kind = quantity,
              .dimension = dimension::energy,
              .example = R"("1e-19 J")",
              .presence = required,
              .range = positive,
              .only_when = {"cohesion", {"hamaker"}},
              .help = "Hamaker's constant of the grains"},
             {.pattern = "contact.shortest_gap",
              .kind = quantity,
              .dimension = dimension::length,
              .example = R"("0.4 nm")",
              .presence = required,
              .range = positive,
              .only_when = {"cohesion", {"hamaker"}},
              .help = "gap of the grains below which the attraction stays"},
             {.pattern = "contact.longest_gap",
              .kind = quantity,
              .dimension = dimension::length,
              .example = R"("40 nm")",
              .presence = required,
              .range = positive,
              .only_when = {"cohesion", {"hamaker"}},
              .help = "gap of the grains beyond which there is none"},
             {.pattern = "contact.rolling_viscosity",
              .kind = number,
              .example = "0.3",
              .standard = "0.3",
              .range = {Range::End::included, Range::End::included, 0.0, 10.0},
              .only_when = {"rolling", {"elastic_plastic_viscous"}},
              .help = "share of critical damping against rolling"},
             {.pattern = "contact.twisting_friction",
              .kind = number,
              .example = "0.1",
              .presence = required,
              .range = not_negative,
              .only_when = {"twisting", {"elastic_plastic"}},
              .help = "coefficient of twisting friction"},
         });
}

/// The numbers of the law once more, for pairs of materials that have their own. The exponents stay: they are the
/// law's. Where a number is a cohesion's strength, a pair may have none.
void append_numbers_of_pairs(Keys& keys) {
  Keys own;
  for (const Key& key : keys) {
    const std::string leaf = leaf_of(key.pattern);
    const bool is_number = key.kind == quantity || key.kind == number;
    if (parent_pattern(key.pattern) != "contact" || !is_number || leaf.ends_with("_exponent")) continue;
    Key row = key;
    row.pattern = "pairs[]." + leaf;
    row.presence = optional;
    row.standard.clear();
    row.when_unset = "that of contact";
    row.only_when = {};
    if (leaf == "surface_tension" || leaf == "hamaker_constant") row.range = not_negative;
    row.help =
        fmt::format("between the two: {} (where contact.{})", key.help, describe_condition(key.only_when));
    own.push_back(row);
  }
  append(keys, own);
}

}  // namespace

void append_contact(Keys& keys) {
  append_parts(keys);
  append_normal_numbers(keys);
  append_other_numbers(keys);
  append_numbers_of_pairs(keys);
}

}  // namespace pulvis::case_file
