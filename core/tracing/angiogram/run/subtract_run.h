#pragma once

#include "core/imaging/subtraction.h"
#include "core/support/result.h"

#include <functional>
#include <optional>
#include <vector>

namespace angiopose::core {

using StopCheck = std::function<bool()>;   ///< true: give up, the result is not wanted any more

/// One mask for each frame (DICOM's time interval differences, PS3.3 C.7.6.10.1): `offset` frames before it; or, while
/// the frames from `reversedFrom` on go forwards, the masks go backwards from `offset` frames before that one.
struct MaskInterval {
    int offset = 1;   ///< below 0: masks lie behind
    std::optional<int> reversedFrom = {};

    bool operator==(const MaskInterval&) const = default;
};

/// How the frames of a run are freed from bones and organs.
struct SubtractionPlan {
    std::vector<int> maskFrames = {};   ///< averaged; none: chosen by `suggestMaskFrames`
    std::optional<MaskInterval> interval = {};   ///< instead of `maskFrames`
    std::optional<Eigen::Vector2d> maskShiftPx = {};   ///< right and down, for all frames; none: found for each
    PixelRelation relation = PixelRelation::Linear;

    bool operator==(const SubtractionPlan&) const = default;
};

/// A subtracted run, with what was decided on the way.
struct SubtractedRun {
    std::vector<ImageF> frames;   ///< polarity as before
    std::vector<int> maskFrames;   ///< averaged; empty for intervals
    std::vector<Eigen::Vector2d> maskShiftsPx;   ///< one per frame; zero where a frame has no mask and stays as it is
};

/// What becomes of the stored frames before they are shown, traced and registered (`angiogram.subtraction` of a case).
struct RunTreatment {
    bool isSubtracted = false;
    bool isComposite = false;   ///< every frame shows all the contrast medium of the run
    SubtractionPlan plan = {};
    std::optional<Polarity> polarity = {};   ///< none: as the file says

    bool changesFrames() const { return isSubtracted || isComposite || polarity; }
    bool operator==(const RunTreatment&) const = default;
};

/// The first frames, before the contrast medium arrives: up to eight with hardly more opacification than the least,
/// frame 0 among them; frame 0 alone where only tracing tells that it shows no contrast while the fullest does. Empty
/// when the run begins with contrast, or has fewer than two frames. `shutter` as for `findField`.
std::vector<int> suggestMaskFrames(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter = {});

/// Every frame less the averaged mask. Fails when mask frames do not exist, none can be suggested, or sizes differ.
Result<SubtractedRun> subtractRun(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                  const StopCheck& isStopRequested = {});

struct SubtractedFrame {
    ImageF frame;
    Eigen::Vector2d maskShiftPx = Eigen::Vector2d::Zero();
};

/// One frame as `subtractRun` gives it, for looking while masks and shift are being chosen.
Result<SubtractedFrame> subtractFrame(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                      int frame);

/// The run as the treatment makes it; headers, suggested frame and size stay. Fails as `subtractRun` does.
Result<Angiogram> treatedRun(const Angiogram& stored, const RunTreatment& treatment,
                             const StopCheck& isStopRequested = {});

}   // namespace angiopose::core