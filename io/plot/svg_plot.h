#pragma once

#include "core/evaluation/report/plot.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct PlotTick {
    double value = 0.0;
    std::string label;
};

/// Where a value lies along an axis of a picture, and where the marks go.
class PlotScale {
public:
    /// The axis' least value lies at `from`, its largest at `to`, both px.
    PlotScale(const core::PlotAxis& axis, double from, double to) : axis_(axis), from_(from), to_(to) {}

    /// Values beyond the ends stay at the ends: not every viewer of SVG clips.
    double position(double value) const;
    /// Round values inside the axis, at most about eight; powers of ten on a logarithmic axis that spans some.
    std::vector<PlotTick> ticks() const;

private:
    core::PlotAxis axis_;
    double from_;
    double to_;
};

/// The plot as a stand-alone SVG picture: thin grid, one colour and dash per line, bands behind, legend beside.
std::string toSvg(const core::Plot& plot);

}   // namespace angiopose::io
