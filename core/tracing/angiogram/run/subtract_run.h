#pragma once

#include "core/imaging/subtraction.h"
#include "core/support/result.h"

#include <functional>
#include <optional>
#include <vector>

namespace angiopose::core {

using StopCheck = std::function<bool()>;   ///< returns true to cancel when the result is no longer needed

/// Separate mask for each frame (DICOM time interval differencing, PS3.3 C.7.6.10.1): the frame `offset` frames
/// earlier; with `reversedFrom`, the masks run backward from `offset` frames before `reversedFrom` while the frames run
/// forward from `reversedFrom`.
struct MaskInterval {
    int offset = 1;   ///< frames from mask to frame; negative if masks come later
    std::optional<int> reversedFrom = {};

    bool operator==(const MaskInterval&) const = default;
};

/// Settings for subtracting bone and soft tissue from the frames of a run.
struct SubtractionPlan {
    std::vector<int> maskFrames = {};   ///< frames to average; if empty, chosen by `suggestMaskFrames`
    std::optional<MaskInterval> interval = {};   ///< if set, replaces `maskFrames`
    std::optional<Eigen::Vector2d> maskShiftPx = {};   ///< right and down, for all frames; if unset, found per frame
    PixelRelation relation = PixelRelation::Linear;

    bool operator==(const SubtractionPlan&) const = default;
};

/// Subtracted run, with the mask frames and shifts used.
struct SubtractedRun {
    std::vector<ImageF> frames;   ///< polarity as in the input
    std::vector<int> maskFrames;   ///< averaged frames; empty for interval plans
    std::vector<Eigen::Vector2d> maskShiftsPx;   ///< one per frame; zero for a frame without mask (unchanged)
};

/// Processing of the stored frames before they are shown, traced and registered (`angiogram.subtraction` of a case).
struct RunProcessing {
    bool isSubtracted = false;
    bool isComposite = false;   ///< whether every frame is replaced by the peak-opacification image of the run
    SubtractionPlan plan = {};
    std::optional<Polarity> polarity = {};   ///< if unset, as stated in the file

    bool changesFrames() const { return isSubtracted || isComposite || polarity; }
    bool operator==(const RunProcessing&) const = default;
};

/// Returns suggested mask frames, before the contrast agent arrives: up to eight with hardly more opacification than
/// the minimum, including frame 0; frame 0 alone if only tracing shows that it has no contrast agent while the
/// peak-opacification frame does. Empty if the run begins with contrast agent or has fewer than two frames. For
/// `shutter`, see `findField`.
std::vector<int> suggestMaskFrames(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter = {});

/// Subtracts the averaged mask from every frame. Fails if a mask frame does not exist, no mask frame can be suggested,
/// or frame sizes differ.
Result<SubtractedRun> subtractRun(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                  const StopCheck& isStopRequested = {});

struct SubtractedFrame {
    ImageF frame;
    Eigen::Vector2d maskShiftPx = Eigen::Vector2d::Zero();
};

/// Subtracts one frame as `subtractRun` does, for a preview while masks and shift are being chosen.
Result<SubtractedFrame> subtractFrame(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                      int frame);

/// Applies the processing to a run; headers, suggested frame and size stay unchanged. Fails under the same conditions
/// as `subtractRun`.
Result<Angiogram> processRun(const Angiogram& stored, const RunProcessing& processing,
                             const StopCheck& isStopRequested = {});

}   // namespace angiopose::core
