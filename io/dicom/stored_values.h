#pragma once

#include "core/imaging/image2d.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// Frames as 16-bit stored values: `value = slope * stored + intercept`, with exactly the numbers in the two strings.
struct StoredValues {
    std::vector<std::uint16_t> pixels;   ///< stored values of all frames, one frame after another
    std::string slope = "1";
    std::string intercept = "0";
};

/// Keeps values unchanged if all are integers from 0 to 65535; otherwise scales them to 16 bits.
StoredValues storedValuesOf(const std::vector<core::ImageF>& frames);

/// Formats a number as a DICOM decimal string (VR DS, at most 16 characters) with the highest possible precision.
std::string decimalString(double value);

}   // namespace angiopose::io
