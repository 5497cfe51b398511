// SPDX-License-Identifier: Apache-2.0
#include "case/key_rows.hpp"

namespace pulvis::case_file {

using enum KeyKind;
using enum Presence;

namespace {

/// Sub-volumes of the die and surfaces that powder flows through.
void append_places(Keys& keys) {
  append(keys, {
                   {.pattern = "measures.parts",
                    .kind = named_tables,
                    .help = "parts of the die that are measured by themselves, besides its halves"},
                   {.pattern = "measures.parts.*.min",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["0 mm", "0 mm", "0 mm"])",
                    .presence = required,
                    .help = "corner of the part with the smallest coordinates, from the lowest corner of the "
                            "die's inside, in its own frame"},
                   {.pattern = "measures.parts.*.max",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["4 mm", "3 mm", "2 mm"])",
                    .presence = required,
                    .help = "corner of the part with the largest coordinates"},

                   {.pattern = "measures.surfaces",
                    .kind = named_tables,
                    .help = "surfaces at rest through which the flow of powder is measured"},
                   {.pattern = "measures.surfaces.*.point",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["0 mm", "0 mm", "5 mm"])",
                    .presence = required,
                    .help = "centre of the surface"},
                   {.pattern = "measures.surfaces.*.normal",
                    .kind = direction,
                    .example = "[0, 0, -1]",
                    .presence = required,
                    .help = "direction in which flow counts as positive"},
                   {.pattern = "measures.surfaces.*.radius",
                    .kind = quantity,
                    .dimension = dimension::length,
                    .example = R"("3 mm")",
                    .when_unset = "the surface has no end",
                    .range = positive,
                    .help = "radius of the surface"},
               });
}

}  // namespace

void append_measures(Keys& keys) {
  append(keys,
         {
             {.pattern = "measures", .kind = table, .help = "what is measured at the end of each phase"},
             {.pattern = "measures.die",
              .kind = name,
              .example = R"("die")",
              .when_unset = "the only box or cylinder among the walls",
              .refers_to = "walls",
              .partner = "region",
              .help = "the wall whose inside is measured, in its own frame"},
             {.pattern = "measures.region",
              .kind = table,
              .partner = "die",
              .help = "a region at rest that is measured instead of a die"},
             {.pattern = "measures.region.shape",
              .kind = choice,
              .example = R"("box")",
              .standard = R"("box")",
              .choices = {"box", "cylinder"},
              .help = "shape of the region"},
         });
  append_shape(keys, "measures.region");
  append(keys,
         {
             {.pattern = "measures.interval",
              .kind = quantity,
              .dimension = dimension::time,
              .example = R"("5 ms")",
              .standard = R"("0 s")",
              .range = not_negative,
              .help = "time between lines of measures.csv; 0 s: a hundredth of the longest phase"},
             {.pattern = "measures.cell_diameters",
              .kind = number,
              .example = "3",
              .standard = "3",
              .range = positive,
              .help = "edge of a cell of the porosity grid in mean parcel diameters"},
             {.pattern = "measures.column_diameters",
              .kind = number,
              .example = "2",
              .standard = "2",
              .range = positive,
              .help = "edge of a column in which the free surface is found, in mean parcel diameters"},
             {.pattern = "measures.energy_ledger",
              .kind = boolean,
              .example = "true",
              .standard = "false",
              .help = "add up where all energy goes: what contacts store, each dissipation, touch and "
                      "separation, walls, "
                      "insertion; steps take more than twice as long"},
             {.pattern = "measures.wall_window",
              .kind = quantity,
              .dimension = dimension::time,
              .example = R"("50 ms")",
              .when_unset = "one cycle where a phase shakes, else a hundredth of the longest phase",
              .range = positive,
              .help = "time over which forces and pressures on walls are averaged; while a phase shakes, "
                      "the nearest number of whole cycles"},
         });
  append_places(keys);
}

}  // namespace pulvis::case_file
