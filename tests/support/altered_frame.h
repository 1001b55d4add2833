#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// An angiogram frame with the grey picture of its drawn vessels.
struct DrawnFrame {
    core::ImageF frame;
    core::ImageF truth;   ///< bright where there is a vessel
    core::Polarity polarity = core::Polarity::VesselsDark;
};

/// Another picture of the same vessels, as another device, export or viewer would have left it.
struct FrameChange {
    std::string name;
    std::function<DrawnFrame(const DrawnFrame&)> apply;
};

/// Sizes, grey values, noise, compression, cuts and turns; "as it is" comes first. Seeded: the same at every call.
std::vector<FrameChange> frameChanges();

}   // namespace angiopose::test