#pragma once

#include "core/support/result.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Length in mm of a unit by its symbol or English name, in any case; nothing for other words.
std::optional<double> lengthUnitMm(std::string_view word);

/// What a table, mesh or VTK file says about itself in words: comments, titles, the head of an STL.
std::string headerText(std::string_view content);

/// How coordinates of a file become patient LPS, mm.
struct CoordinateRule {
    double unitMm = 1.0;
    bool isUnitStated = false;   ///< by the file
    bool isRas = false;
    core::Messages notes;   ///< on a unit that the file states

    Eigen::Vector3d operator()(const Eigen::Vector3d& point) const
    {
        return unitMm * (isRas ? Eigen::Vector3d(-point.x(), -point.y(), point.z()) : point);
    }
};

/// By what the header states; `askedUnitMm` above 0 goes before it. Fails on a unit that is none, and on axes that are
/// neither LPS nor RAS.
core::Result<CoordinateRule> coordinateRule(std::string_view header, double askedUnitMm, const std::string& path);

}   // namespace angiopose::io
