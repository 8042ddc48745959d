// A plot as an SVG document: its frame, an axis of counts, and text and lines in it, in pixels.
//
// Guarantees: the text is well-formed, with no script and no reference to another file.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

#include "cli/layer.h"

namespace flowcert::cli {

// The picture, and the rectangle between the axes.
inline constexpr double kPictureWidth = 720, kPictureHeight = 420;
inline constexpr double kPlotLeft = 90, kPlotRight = 700, kPlotTop = 60, kPlotBottom = 360;

[[nodiscard]] std::string text_at(double x, double y, const char* anchor, const std::string& text, int size = 12);
[[nodiscard]] std::string line_from(double x1, double y1, double x2, double y2, const char* color);

// Ticks of an axis of counts: 2 to 5 of them, at multiples of 1, 2 or 5 times a power of ten, from 0 to the largest
// count or above it.
[[nodiscard]] std::vector<double> count_ticks(double largest);

// A line across the plot for each tick, with its count; at(tick) is its height in pixels from above.
[[nodiscard]] std::string lines_of_counts(const std::vector<double>& ticks, const std::function<double(double)>& at);

// The document: title and source above, what is drawn, the axes, and what the lower axis has.
[[nodiscard]] std::string svg_plot(const std::string& title, const std::string& source, const std::string& drawn,
                                   const std::string& lower_axis);

}  // namespace flowcert::cli
