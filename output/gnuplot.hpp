// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

// gnuplot as a program of its own: scripts go in, SVG images come out.
namespace pulvis {

/// Whether gnuplot, which draws the figures, can be called.
bool can_draw_figures();

/// What gnuplot draws for a script. Throws Failure(Exit::io) with the remedy if gnuplot is missing or fails; `name`
/// is that of the figure, for the message.
std::string drawn_by_gnuplot(const std::string& script, const std::string& name);

namespace gnuplot {

/// Text between single quotes; control characters, which no SVG may hold, become blanks.
std::string quoted(const std::string& text);

/// The k-th of the colours that the colour-blind tell apart, black first: "#0072b2".
const char* colour(std::size_t k);

/// The start of a script that draws an image of so many pixels.
std::string head(int width, int height);

/// A line of a data block: the numbers, or an empty one (a gap) if one of them is not finite.
std::string data_line(const std::vector<double>& numbers);

}  // namespace gnuplot

/// Text as a cell of a CSV file, in quotes.
std::string csv_quoted(const std::string& text);

}  // namespace pulvis
