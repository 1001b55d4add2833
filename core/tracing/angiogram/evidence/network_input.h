#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// A frame as the network reads it: grey against the surroundings, and grey within the whole frame, so that neither
/// brightness nor contrast matters. Padded to whole cells of the network's coarsest level.
struct NetworkInput {
    static constexpr int channelCount = 2;

    int width = 0;   ///< of the frame at reduced size
    int height = 0;
    int paddedWidth = 0;
    int paddedHeight = 0;
    std::vector<float> values;   ///< both channels, row by row
};

/// `resources/network/train_vessel_network.py` does the same (`network_input`).
NetworkInput networkInput(const ImageF& vesselsDark);

/// Means over the pixels' areas when smaller, linear between pixel centres when larger.
ImageF resampled(const ImageF& image, int width, int height);

}   // namespace angiopose::core
