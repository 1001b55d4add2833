#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// An angiogram frame with the grayscale mask of its drawn vessels.
struct DrawnFrame {
    core::ImageF frame;
    core::ImageF truth;   ///< bright at vessels
    core::Polarity polarity = core::Polarity::VesselsDark;
};

/// A variant of the image of the same vessels, as from another device, export or viewer.
struct FrameChange {
    std::string name;
    std::function<DrawnFrame(const DrawnFrame&)> apply;
};

/// Changes of size, gray values, noise, compression, cropping and rotation; the unchanged frame comes first. Seeded:
/// identical at every call.
std::vector<FrameChange> frameChanges();

}   // namespace angiopose::test
