#pragma once

#include "core/evaluation/statistics/proportion.h"
#include "core/evaluation/trial/run_record.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

struct PlotAxis {
    std::string label;
    double min = 0.0;
    double max = 1.0;
    bool isLogarithmic = false;   ///< logarithmic to base 10; requires min and max above 0
};

/// One line or one set of markers in a plot; points outside the axes are clipped.
struct PlotSeries {
    std::string name;
    std::vector<Eigen::Vector2d> points;   ///< sorted by x
    std::vector<Interval> bands;   ///< confidence interval at each point; may be empty
    bool isScatter = false;   ///< if true, drawn as separate markers instead of a line
};

/// A line plot; io draws it as SVG.
struct Plot {
    std::string id;   ///< file name without extension
    std::string title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
};

/// Returns the plots for which the runs have data: cumulative error, success rate over initial error, convergence.
std::vector<Plot> makePlots(const RunSet& runs);

}   // namespace angiopose::core
