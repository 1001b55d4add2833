#pragma once

#include "core/imaging/image2d.h"
#include "tests/support/drawn_vessels.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// A frame with something drawn into it that is no vessel.
struct ObjectFrame {
    core::ImageF frame;
    std::vector<Path> courses;   ///< where it runs
    double reachPx = 0.0;   ///< how far from its course it is seen
};

/// Something that is no vessel, drawn into a frame with dark vessels.
struct ForeignObject {
    std::string name;
    bool isDevice = false;   ///< a catheter or wire: to be flagged; everything else is not to be traced at all
    std::function<ObjectFrame(const core::ImageF& frame, std::uint64_t seed)> draw;
};

/// Borders of the field (round, rectangular and turned, soft), shutters, letters, catheters, wires, sternal wires and
/// clips. Seeded: the same at every call.
std::vector<ForeignObject> foreignObjects();

/// The frame with its vessels painted over by what is around them, grain and all: what an exposure before the contrast
/// medium would show. `vessels` are widened by `marginPx` first.
core::ImageF withoutVessels(const core::ImageF& frame, const core::Mask2d& vessels, int marginPx, std::uint64_t seed);

}   // namespace angiopose::test
