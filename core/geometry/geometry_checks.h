#pragma once

#include "core/geometry/c_arm.h"
#include "core/geometry/gantry_header.h"
#include "core/support/message.h"

namespace angiopose::core {

/// Returns messages about values that contradict each other, the header or physics, each with a suggestion of what to
/// check (ALGORITHMS §5.2, §5.6): distances, magnification, pixel spacing against field of view, intensifier, detector
/// and calibration, pixel aspect, angles, principal point. `imageSizePx` is (columns, rows), or zero if unknown.
/// Missing values are not contradictions.
Messages findContradictions(const CArm& cArm, const GantryHeader& header = {},
                            const Eigen::Vector2i& imageSizePx = Eigen::Vector2i::Zero());

/// Returns messages about the geometry values still missing for a camera and an initial pose, each with instructions
/// for supplying it.
Messages findMissingGeometry(const CArm& cArm);

}   // namespace angiopose::core
