#pragma once

#include "core/support/result.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the length in mm of a unit given by symbol or English name (case-insensitive); nullopt for other words.
std::optional<double> lengthUnitMm(std::string_view word);

/// Returns the descriptive text of a table, mesh or VTK file: comments, titles, the header of an STL file.
std::string headerText(std::string_view content);

/// Conversion from the coordinates of a file to patient LPS, mm.
struct CoordinateConversion {
    double unitMm = 1.0;
    bool isUnitStated = false;   ///< whether the file states its unit
    bool isRas = false;
    core::Messages notes;   ///< notes about a unit stated in the file

    Eigen::Vector3d operator()(const Eigen::Vector3d& point) const
    {
        return unitMm * (isRas ? Eigen::Vector3d(-point.x(), -point.y(), point.z()) : point);
    }
};

/// Derives the conversion from the header; `requestedUnitMm` takes precedence if above 0. Fails if the unit is unknown
/// or the axes are neither LPS nor RAS.
core::Result<CoordinateConversion> coordinateConversion(std::string_view header, double requestedUnitMm,
                                                        const std::string& path);

}   // namespace angiopose::io
