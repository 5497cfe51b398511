// SPDX-License-Identifier: Apache-2.0
#include "case/key_rows.hpp"

// The key table as a whole, and the rows that several tables or none in particular have.
namespace pulvis::case_file {

using enum KeyKind;
using enum Presence;

void append_shape(Keys& keys, const std::string& table) {
  const Condition box{"shape", {"box"}}, cylinder{"shape", {"cylinder"}};
  append(keys, {
                   {.pattern = table + ".min",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["0 mm", "0 mm", "0 mm"])",
                    .presence = required,
                    .only_when = box,
                    .help = "corner of the box with the smallest coordinates"},
                   {.pattern = table + ".max",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["2 mm", "2 mm", "5 mm"])",
                    .presence = required,
                    .only_when = box,
                    .help = "corner of the box with the largest coordinates"},
                   {.pattern = table + ".base",
                    .kind = vector,
                    .dimension = dimension::length,
                    .example = R"(["0 mm", "0 mm", "0 mm"])",
                    .presence = required,
                    .only_when = cylinder,
                    .help = "centre of the lower end of the cylinder"},
                   {.pattern = table + ".axis",
                    .kind = direction,
                    .example = "[0, 0, 1]",
                    .standard = "[0, 0, 1]",
                    .only_when = cylinder,
                    .help = "direction from the base to the other end"},
                   {.pattern = table + ".radius",
                    .kind = quantity,
                    .dimension = dimension::length,
                    .example = R"("1 mm")",
                    .presence = required,
                    .range = positive,
                    .only_when = cylinder,
                    .help = "radius of the cylinder"},
                   {.pattern = table + ".height",
                    .kind = quantity,
                    .dimension = dimension::length,
                    .example = R"("5 mm")",
                    .presence = required,
                    .range = positive,
                    .only_when = cylinder,
                    .help = "length of the cylinder along its axis"},
               });
}

void append_choices(Keys& keys) {
  append(keys, {
                   {.pattern = "time", .kind = table, .help = "the time step"},
                   {.pattern = "time.fraction",
                    .kind = number,
                    .example = "0.1",
                    .standard = "0.2",
                    .range = fraction,
                    .partner = "step",
                    .help = "time step over the smallest of the Rayleigh, Hertz and cohesive limits"},
                   {.pattern = "time.step",
                    .kind = quantity,
                    .dimension = dimension::time,
                    .example = R"("1 us")",
                    .when_unset = "found from the fraction",
                    .range = positive,
                    .partner = "fraction",
                    .help = "time step, fixed"},
                   {.pattern = "time.characteristic_speed",
                    .kind = quantity,
                    .dimension = dimension::speed,
                    .example = R"("0.5 m/s")",
                    .when_unset = "estimated from the case",
                    .range = positive,
                    .help = "speed of the fastest impacts, for the Hertz limit"},
               });
  append_measures(keys);
  append(
      keys,
      {
          {.pattern = "output", .kind = table, .help = "what is written besides the results"},
          {.pattern = "output.interval",
           .kind = quantity,
           .dimension = dimension::time,
           .example = R"("20 ms")",
           .standard = R"("0 s")",
           .range = not_negative,
           .help = "time between frames for ParaView; 0 s: only at the end of phases"},
          {.pattern = "output.log_interval",
           .kind = quantity,
           .dimension = dimension::time,
           .example = R"("1 ms")",
           .standard = R"("0 s")",
           .range = not_negative,
           .help = "time between lines of log.csv; 0 s: a hundredth of the longest phase"},
          {.pattern = "output.checkpoint_interval",
           .kind = quantity,
           .dimension = dimension::time,
           .example = R"("1 h")",
           .standard = R"("15 min")",
           .range = not_negative,
           .help = "time on the clock between checkpoints, from which `pulvis run --resume` goes on; there "
                   "is one at the end of each phase too; 0 s: only those"},
          {.pattern = "output.picture",
           .kind = boolean,
           .example = "false",
           .standard = "true",
           .help = "draw the filled die, cut open"},
          {.pattern = "output.report",
           .kind = boolean,
           .example = "false",
           .standard = "true",
           .help = "put the results together on one page, report.html, at the end of the run"},
      });
}

const std::vector<Key>& all_keys() {
  static const Keys table = [] {
    Keys keys;
    append_matter(keys);
    append_process(keys);
    append_choices(keys);
    return keys;
  }();
  return table;
}

}  // namespace pulvis::case_file
