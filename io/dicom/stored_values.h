#pragma once

#include "core/imaging/image2d.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// Frames as 16-bit stored values: `value = slope * stored + intercept`, with exactly the two numbers in the texts.
struct StoredValues {
    std::vector<std::uint16_t> pixels;   ///< all frames, one after another
    std::string slope = "1";
    std::string intercept = "0";
};

/// Stores integers from 0 to 65535 unchanged; scales anything else to 16 bits.
StoredValues storedValuesOf(const std::vector<core::ImageF>& frames);

/// A number as DICOM text of at most 16 characters (VR DS), with the highest possible precision.
std::string decimalString(double value);

}   // namespace angiopose::io