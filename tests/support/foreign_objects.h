#pragma once

#include "core/imaging/image2d.h"
#include "tests/support/drawn_vessels.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// A frame with a drawn object that is not a vessel.
struct ObjectFrame {
    core::ImageF frame;
    std::vector<Path> courses;   ///< paths of the object
    double reachPx = 0.0;   ///< distance from its path up to which the object is visible
};

/// An object other than a vessel, to be drawn into a frame with dark vessels.
struct ForeignObject {
    std::string name;
    bool isDevice = false;   ///< a catheter or wire, which must be flagged; no other object may be traced at all
    std::function<ObjectFrame(const core::ImageF& frame, std::uint64_t seed)> draw;
};

/// Edges of the field (round, rectangular and rotated, soft), shutters, letters, catheters, wires, sternal wires and
/// clips. Seeded: identical at every call.
std::vector<ForeignObject> foreignObjects();

/// The frame with its vessels replaced by their surroundings including the noise, as in an exposure before the contrast
/// agent. `vessels` are dilated by `marginPx` first.
core::ImageF withoutVessels(const core::ImageF& frame, const core::Mask2d& vessels, int marginPx, std::uint64_t seed);

}   // namespace angiopose::test
