#include "core/tracing/subtract_run.h"

#include "core/tracing/suggest_frame.h"

#include <algorithm>
#include <string>

namespace core {
namespace {

constexpr std::size_t mostMaskFrames = 8;
constexpr double emptyShare = 0.15;   // of the rise from the emptiest to the fullest frame
constexpr double leastRise = 1.5;   // fullest to first frame, or the run begins with contrast

std::string problemWith(const std::vector<ImageF>& frames, const std::vector<int>& maskFrames)
{
    if (frames.size() < 2) {
        return "The run has one frame: there is nothing to subtract. Choose a run with frames before the contrast.";
    }
    const auto differs = [&](const ImageF& frame) {
        return frame.width != frames.front().width || frame.height != frames.front().height;
    };
    if (std::any_of(frames.begin(), frames.end(), differs)) {
        return "The frames of the run differ in size and cannot be subtracted.";
    }
    for (const int index : maskFrames) {
        if (index < 0 || index >= static_cast<int>(frames.size())) {
            return "Mask frame " + std::to_string(index) + " does not exist. The run has frames 0 to " +
                   std::to_string(frames.size() - 1) + ".";
        }
    }
    return {};
}

}   // namespace

std::vector<int> suggestMaskFrames(const std::vector<ImageF>& frames, Polarity polarity)
{
    const std::vector<double> curve = opacificationCurve(frames, polarity);
    if (curve.size() < 2) {
        return {};
    }
    const auto [least, most] = std::minmax_element(curve.begin(), curve.end());
    if (*most < leastRise * curve.front() || !(*most > 0.0)) {
        return {};
    }
    const double limit = *least + emptyShare * (*most - *least);
    std::vector<int> masks;
    while (masks.size() < std::min(mostMaskFrames, curve.size()) && curve[masks.size()] <= limit) {
        masks.push_back(static_cast<int>(masks.size()));
    }
    return masks;
}

Result<SubtractedRun> subtractRun(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan)
{
    if (const std::string problem = problemWith(frames, plan.maskFrames); !problem.empty()) {
        return Error{problem};
    }
    SubtractedRun run;
    run.maskFrames = plan.maskFrames.empty() ? suggestMaskFrames(frames, polarity) : plan.maskFrames;
    if (run.maskFrames.empty()) {
        return Error{
            "The run shows contrast medium from its first frame on, so no frame serves as mask. Name the mask "
            "frames, or trace without subtraction."};
    }
    const ImageF mask = meanFrame(frames, run.maskFrames);
    for (const ImageF& frame : frames) {
        run.maskShiftsPx.push_back(plan.maskShiftPx ? *plan.maskShiftPx : maskShift(mask, frame, plan.relation));
        run.frames.push_back(subtracted(frame, mask, run.maskShiftsPx.back(), plan.relation));
    }
    return run;
}

}   // namespace core
