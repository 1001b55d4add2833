#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/tracer.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

/// Course of the opacified vessels and their widths in the image.
struct WideLine {
    Pixels at;
    std::vector<double> radiusPx;

    /// Width of the vessel at a pixel; none outside the vessels.
    double widthAt(const Eigen::Vector2d& pixel) const;
};

WideLine wideLines(const RootedTree& shown, const std::vector<std::size_t>& filled,
                   const core::RigidTransform& cameraFromPatient);

/// Adds widths with the errors of a tracer: all too wide or too narrow by a common factor, each by a further one that
/// is correlated between neighbors, none below 1.5 pixels.
void addWidths(core::Centerline2d& target, const WideLine& lines, ForeignRandom random);

}   // namespace angiopose::benchmarks
