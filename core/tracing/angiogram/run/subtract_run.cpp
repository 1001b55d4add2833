#include "core/tracing/angiogram/run/subtract_run.h"

#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/tracing/angiogram/run/suggest_frame.h"
#include "core/tracing/angiogram/trace_angiogram.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace angiopose::core {
namespace {

constexpr std::size_t maxMaskFrames = 8;
constexpr double maxUnopacifiedRise = 0.15;   // limit for mask frames, as a fraction of the rise to the peak
constexpr double minRise = 1.5;   // minimum ratio of peak to first opacification; lower if opacified from the start

std::optional<Message> problemWith(const std::vector<ImageF>& frames, const SubtractionPlan& plan)
{
    if (frames.size() < 2) {
        return messages::subtractionOneFrame();
    }
    const auto differs = [&](const ImageF& frame) {
        return frame.width != frames.front().width || frame.height != frames.front().height;
    };
    if (std::any_of(frames.begin(), frames.end(), differs)) {
        return messages::subtractionSizesDiffer();
    }
    for (const int index : plan.maskFrames) {
        if (index < 0 || index >= static_cast<int>(frames.size())) {
            return messages::subtractionMaskMissing(index + 1, frames.size());
        }
    }
    return {};
}

/// Returns whether a frame could not be decoded or shows nothing; it is then neither used as a mask nor subtracted.
bool isBlank(const ImageF& frame)
{
    return std::ranges::all_of(frame.pixels, [&](float value) { return value == frame.pixels.front(); });
}

/// Removes blank frames from the mask frames unless all of them are blank.
void excludeBlankFrames(const std::vector<ImageF>& frames, std::vector<int>& maskFrames)
{
    std::vector<int> usable = maskFrames;
    std::erase_if(usable, [&](int index) { return isBlank(frames[static_cast<std::size_t>(index)]); });
    if (!usable.empty()) {
        maskFrames = std::move(usable);
    }
}

/// Checks the plan and chooses its mask frames if none are given.
Result<SubtractionPlan> resolvePlan(const std::vector<ImageF>& frames, Polarity polarity, SubtractionPlan plan)
{
    if (const auto problem = problemWith(frames, plan)) {
        return Error(*problem);
    }
    if (plan.interval) {
        plan.maskFrames.clear();
        return plan;
    }
    if (plan.maskFrames.empty()) {
        plan.maskFrames = suggestMaskFrames(frames, polarity);
    }
    if (plan.maskFrames.empty()) {
        return Error(messages::subtractionNoMask());
    }
    excludeBlankFrames(frames, plan.maskFrames);
    return plan;
}

/// Returns the index of the mask that `interval` assigns to a frame; nullopt if the mask lies outside the run.
std::optional<std::size_t> intervalMaskIndex(const MaskInterval& interval, int frame, int frameCount)
{
    const int first = interval.reversedFrom.value_or(0);
    const int index = interval.reversedFrom ? 2 * first - interval.offset - frame : frame - interval.offset;
    const bool exists = index >= 0 && index < frameCount && index != frame && frame >= first;
    return exists ? std::optional(static_cast<std::size_t>(index)) : std::nullopt;
}

SubtractedFrame subtractMask(const ImageF& frame, const ImageF& mask, const SubtractionPlan& plan)
{
    if (isBlank(frame) && !isBlank(mask)) {
        return {frame};
    }
    const Eigen::Vector2d shift = plan.maskShiftPx ? *plan.maskShiftPx : findMaskShift(mask, frame, plan.relation);
    return {subtracted(frame, mask, shift, plan.relation), shift};
}

/// Subtracts the mask from one frame. `averaged` is the mean of the mask frames; plans with an interval ignore it.
SubtractedFrame subtractMask(const std::vector<ImageF>& frames, std::size_t index, const ImageF& averaged,
                             const SubtractionPlan& plan)
{
    if (!plan.interval) {
        return subtractMask(frames[index], averaged, plan);
    }
    const auto mask = intervalMaskIndex(*plan.interval, static_cast<int>(index), static_cast<int>(frames.size()));
    return mask ? subtractMask(frames[index], frames[*mask], plan) : SubtractedFrame{frames[index]};
}

bool showsContrast(const ImageF& frame, Polarity polarity, const Mask2d& shutter)
{
    const auto trace = traceAngiogram(frame, polarity, {}, shutter);
    return trace && trace.value().warnings.empty();
}

}   // namespace

std::vector<int> suggestMaskFrames(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter)
{
    const std::vector<double> curve = opacificationCurve(frames, polarity, shutter);
    std::vector<int> usable;
    for (int k = 0; k < static_cast<int>(frames.size()); ++k) {
        if (!isBlank(frames[static_cast<std::size_t>(k)])) {
            usable.push_back(k);
        }
    }
    if (usable.size() < 2) {
        return {};
    }
    const auto opacity = [&](int frame) { return curve[static_cast<std::size_t>(frame)]; };
    const double least = opacity(std::ranges::min(usable, {}, opacity));
    const double most = opacity(std::ranges::max(usable, {}, opacity));
    if (!(most > 0.0)) {
        return {};
    }
    if (most < minRise * opacity(usable.front())) {   // the edges of bone and soft tissue also produce ridges
        const auto isOpacified = [&](int frame) {
            return showsContrast(frames[static_cast<std::size_t>(frame)], polarity, shutter);
        };
        const bool contrastArrives = !isOpacified(usable.front()) && isOpacified(std::ranges::max(usable, {}, opacity));
        return contrastArrives ? std::vector<int>{usable.front()} : std::vector<int>();
    }
    const double limit = least + maxUnopacifiedRise * (most - least);
    const auto firstOpacified = std::ranges::find_if(usable, [&](int frame) { return opacity(frame) > limit; });
    usable.erase(firstOpacified, usable.end());
    usable.resize(std::min(maxMaskFrames, usable.size()));
    return usable;
}

Result<SubtractedRun> subtractRun(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                  const StopCheck& isStopRequested)
{
    const auto chosen = resolvePlan(frames, polarity, plan);
    if (!chosen) {
        return chosen.error();
    }
    const ImageF mask = meanFrame(frames, chosen.value().maskFrames);
    SubtractedRun run;
    run.maskFrames = chosen.value().maskFrames;
    run.frames.resize(frames.size());
    run.maskShiftsPx.resize(frames.size());
    const bool isComplete = parallelFor(
        frames.size(), threadCount(0),
        [&](std::size_t i) {
            SubtractedFrame result = subtractMask(frames, i, mask, chosen.value());
            run.frames[i] = std::move(result.frame);
            run.maskShiftsPx[i] = result.maskShiftPx;
        },
        [&](double) { return !isStopRequested || !isStopRequested(); });
    return isComplete ? Result<SubtractedRun>(std::move(run)) : Cancellation{messages::subtractionStopped()};
}

Result<SubtractedFrame> subtractFrame(const std::vector<ImageF>& frames, Polarity polarity, const SubtractionPlan& plan,
                                      int frame)
{
    const auto chosen = resolvePlan(frames, polarity, plan);
    if (!chosen) {
        return chosen.error();
    }
    const ImageF mask = meanFrame(frames, chosen.value().maskFrames);
    return subtractMask(frames, static_cast<std::size_t>(frame), mask, chosen.value());
}

Result<Angiogram> processRun(const Angiogram& stored, const RunProcessing& processing, const StopCheck& isStopRequested)
{
    Angiogram run = stored;
    run.polarity = processing.polarity.value_or(stored.polarity);
    if (processing.isSubtracted) {
        SubtractionPlan plan = processing.plan;
        if (plan.maskFrames.empty() && !plan.interval) {
            plan.maskFrames = suggestMaskFrames(stored.frames, run.polarity, stored.shutter);
        }
        auto subtracted = subtractRun(stored.frames, run.polarity, plan, isStopRequested);
        if (!subtracted) {
            return subtracted.error();
        }
        run.frames = std::move(subtracted).value().frames;
    }
    if (processing.isComposite) {
        run.frames.assign(run.frames.size(), peakOpacificationImage(run.frames, run.polarity));
    }
    return run;
}

}   // namespace angiopose::core
