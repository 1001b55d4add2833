#pragma once

#include "core/imaging/subtraction.h"
#include "core/support/result.h"

#include <optional>
#include <vector>

namespace core {

/// How the frames of a run are freed from bones and organs.
struct SubtractionPlan {
    std::vector<int> maskFrames = {};   ///< averaged; none: chosen by `suggestMaskFrames`
    std::optional<Eigen::Vector2d> maskShiftPx = {};   ///< right and down, for all frames; none: found for each
    PixelRelation relation = PixelRelation::Linear;

    bool operator==(const SubtractionPlan&) const = default;
};

/// A subtracted run, with what was decided on the way.
struct SubtractedRun {
    std::vector<ImageF> frames;   ///< polarity as before
    std::vector<int> maskFrames;
    std::vector<Eigen::Vector2d> maskShiftsPx;   ///< one per frame
};

/// The first frames, before the contrast medium arrives: up to eight with hardly more opacification than the least,
/// frame 0 among them. Empty when the run begins with contrast, or has fewer than two frames.
std::vector<int> suggestMaskFrames(const std::vector<ImageF>& frames, Polarity polarity);

/// Every frame less the averaged mask. Fails when mask frames do not exist, none can be suggested, or sizes differ.
Result<SubtractedRun> subtractRun(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan);

}   // namespace core
