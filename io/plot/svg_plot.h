#pragma once

#include "core/evaluation/report/plot.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct PlotTick {
    double value = 0.0;
    std::string label;
};

/// Maps values to positions along an axis of a plot, and determines the ticks.
class PlotScale {
public:
    /// Maps the minimum of the axis to `from` and the maximum to `to`, both in px.
    PlotScale(const core::PlotAxis& axis, double from, double to) : axis_(axis), from_(from), to_(to) {}

    /// Returns the position of a value. Clamps values beyond the ends of the axis, because not every SVG viewer clips.
    double position(double value) const;
    /// Returns at most about eight round values within the axis; on a logarithmic axis that spans several powers of
    /// ten, returns the powers of ten.
    std::vector<PlotTick> ticks() const;

private:
    core::PlotAxis axis_;
    double from_;
    double to_;
};

/// Returns the plot as a stand-alone SVG: thin grid, a distinct color and dash pattern for each line, bands behind the
/// lines, legend at the side.
std::string toSvg(const core::Plot& plot);

}   // namespace angiopose::io
