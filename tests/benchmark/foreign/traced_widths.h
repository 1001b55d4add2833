#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/tracer.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

/// Where the filled vessels run and how wide the image shows them.
struct WideLine {
    Pixels at;
    std::vector<double> radiusPx;

    /// Of the vessel at a pixel; nothing beside the vessels.
    double widthAt(const Eigen::Vector2d& pixel) const;
};

WideLine wideLines(const RootedTree& shown, const std::vector<std::size_t>& filled,
                   const core::RigidTransform& cameraFromPatient);

/// Widths as a tracer tells them: all of them too wide or too narrow by some share, each by another that neighbours
/// have in common, none below a pixel and a half.
void addWidths(core::Centerline2d& target, const WideLine& lines, ForeignRandom random);

}   // namespace angiopose::benchmarks
