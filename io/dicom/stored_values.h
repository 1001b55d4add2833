#pragma once

#include "core/imaging/image2d.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// Frames as 16-bit stored values: `value = slope * stored + intercept`, the two exactly as the texts say.
struct StoredValues {
    std::vector<std::uint16_t> pixels;   ///< all frames, one after the other
    std::string slope = "1";
    std::string intercept = "0";
};

/// Whole numbers from 0 to 65535 are stored as they are; anything else is spread over the 16 bits.
StoredValues storedValuesOf(const std::vector<core::ImageF>& frames);

/// A number as DICOM text of at most 16 characters (VR DS), as exact as that allows.
std::string decimalString(double value);

}   // namespace angiopose::io