#include "core/tracing/angiogram/trace_angiogram.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/mask_morphology.h"
#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/tracing/angiogram/curves/bridge_gaps.h"
#include "core/tracing/angiogram/curves/contrast_score.h"
#include "core/tracing/angiogram/curves/curve_refinement.h"
#include "core/tracing/angiogram/curves/devices_from_edge.h"
#include "core/tracing/angiogram/curves/earlier_structures.h"
#include "core/tracing/angiogram/curves/rasterize_vessels.h"
#include "core/tracing/angiogram/curves/skeleton_graph.h"
#include "core/tracing/angiogram/curves/straight_crossings.h"
#include "core/tracing/angiogram/curves/suspect_curves.h"
#include "core/tracing/angiogram/curves/vessel_branches.h"
#include "core/tracing/angiogram/curves/vessel_trunk.h"
#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "core/tracing/angiogram/frame/denoise_frame.h"
#include "core/tracing/angiogram/frame/drawn_mask.h"
#include "core/tracing/angiogram/frame/field_mask.h"
#include "core/tracing/angiogram/frame/flatten_background.h"
#include "core/tracing/angiogram/frame/report_page.h"
#include "core/tracing/angiogram/frame/widest_vessel.h"
#include "core/tracing/angiogram/frame/working_size.h"
#include "core/tracing/angiogram/ridges/background_between_vessels.h"
#include "core/tracing/angiogram/ridges/clutter_level.h"
#include "core/tracing/angiogram/ridges/vessel_threshold.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double surroundingsInRadii = 3.0;
// Thinning splits the crossing of two vessels into two junctions about one vessel width apart.
constexpr double crossingInRadii = 2.0;
constexpr std::size_t frameSamples = 200000;
// Filter halos around a strong vessel hide faint branches close to it; gaps up to this length are bridged if the vessel
// evidence is almost sufficient along the whole gap.
constexpr double gapReachPx = 14.0;
constexpr double minEvidenceInGap = 0.75;
constexpr int maxTracingThreads = 2;   // memory bandwidth limits the gain from more threads
constexpr double minStationaryFraction = 0.35;   // minimum fraction of the traced length, if nothing else is opacified
constexpr double maxStationaryFraction = 0.5;   // above this, the vessels are stationary as well (phantom or patient)

bool isFinite(const ImageF& frame)
{
    constexpr std::uint32_t sign = 0x80000000U;
    constexpr std::uint32_t infinite = 0x7f800000U;
    std::uint32_t largest = 0;   // comparing bit patterns is four times faster
    for (const float value : frame.pixels) {
        largest = std::max(largest, std::bit_cast<std::uint32_t>(value) & ~sign);
    }
    return largest < infinite;
}

std::optional<Message> problemWith(const ImageF& frame)
{
    if (frame.isEmpty()) {
        return messages::frameEmpty();
    }
    if (!isFinite(frame)) {
        return messages::frameNotFinite();
    }
    const float first = frame.pixels.front();
    if (std::all_of(frame.pixels.begin(), frame.pixels.end(), [first](float value) { return value == first; })) {
        return messages::frameOfOneGrayValue();
    }
    return {};
}

std::optional<Message> problemWith(const TraceOptions& options)
{
    const auto& [thinnest, widest, branchLength, componentLength, sensitivity] = options;
    if (!(thinnest > 0.0 && thinnest <= widest && std::isfinite(widest))) {
        return messages::traceRadiiUnusable(Quantity{thinnest, Quantity::significantDigits, "px"},
                                            Quantity{widest, Quantity::significantDigits, "px"});
    }
    if (!(sensitivity > 0.0 && std::isfinite(sensitivity))) {
        return messages::traceSensitivityUnusable(Quantity{sensitivity, Quantity::significantDigits});
    }
    return {};
}

ImageF withVesselsDark(const ImageF& frame, Polarity polarity)
{
    ImageF dark = frame;
    if (polarity == Polarity::VesselsBright) {
        for (float& value : dark.pixels) {
            value = -value;
        }
    }
    return dark;
}

Mask2d without(Mask2d mask, const Mask2d& part)
{
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] = part.pixels[i] != 0 ? 0 : mask.pixels[i];
    }
    return mask;
}

/// Returns the field without shutters, borders and burned-in text.
Mask2d tracedField(const ImageF& vesselsDark, const TraceOptions& options, const Mask2d& shutter)
{
    Mask2d field;
    Mask2d text;
    runInParallel([&] { field = findField(vesselsDark, 2.0 * options.maxVesselRadiusPx, shutter); },
                  [&] { text = burnedInTextMask(vesselsDark); });
    return without(std::move(field), text);
}

/// Returns the ridge strength to be scaled to 1: its 99.9 % quantile.
float saturationLevel(const ImageF& ridges)
{
    return std::max(grayQuantile(subsample(ridges.pixels, frameSamples), 0.999), 1e-12F);
}

/// Returns the ridges scaled to 0…1.
ImageF normalized(ImageF ridges, float top)
{
    for (float& value : ridges.pixels) {
        value = std::min(1.0F, value / top);
    }
    return ridges;
}

/// Closes short gaps between vessel pixels, then fills holes (some created by the bridges) that are smaller than any
/// vessel loop and not background between two vessels.
Mask2d completeVessels(const Mask2d& vessels, const Mask2d& background, const ImageF& evidence, int smallestLoopPx)
{
    const Mask2d bridged = bridgeGaps(without(vessels, background), evidence, gapReachPx, minEvidenceInGap);
    return without(fillSmallHoles(bridged, smallestLoopPx), background);
}

std::vector<Curve2d> centeredCurves(std::vector<std::vector<Eigen::Vector2d>> paths, const ImageF& opacity,
                                    const Mask2d& field, double maxRadiusPx)
{
    std::erase_if(paths, [&](const auto& path) { return crossesFieldStraight(path, field); });
    std::vector<Curve2d> curves(paths.size());
    parallelFor(
        paths.size(), std::min(maxTracingThreads, threadCount(0)),
        [&](std::size_t k) { curves[k] = centerCurve(paths[k], static_cast<int>(k) + 1, opacity, maxRadiusPx); },
        [](double) { return true; });
    return curves;
}

/// Vessels found in a frame of typical size.
struct DetectedVessels {
    Mask2d fieldMask;
    ImageF vesselness;
    double clutter = 0.0;   ///< in units of the vesselness
    ImageF opacity;
    std::vector<std::vector<Eigen::Vector2d>> paths;   ///< center paths of the vessel mask
};

DetectedVessels detectVessels(const ImageF& vesselsDark, const TraceOptions& options, const Mask2d& shutter)
{
    DetectedVessels detected;
    detected.fieldMask = tracedField(vesselsDark, options, shutter);
    detected.opacity =
        flattenBackground(vesselsDark, detected.fieldMask, surroundingsInRadii * options.maxVesselRadiusPx);
    const ClutterEstimate clutter(detected.opacity, detected.fieldMask,
                                  ridgeScales(options.minVesselRadiusPx, options.maxVesselRadiusPx));
    const ImageF ridges = ridgeStrength(detected.opacity, clutter.scales());
    double clutterLevel = 0.0;
    ImageF clear;
    runInParallel([&] { clear = removeStarArtifacts(ridges, detected.opacity); },
                  [&] { clutterLevel = clutter.level(ridges); });
    const double unit = vesselThreshold(clear, clutterLevel, options.sensitivity);
    const ImageF evidence = vesselEvidence(clear, detected.fieldMask, unit);
    const int smallestLoopPx = static_cast<int>(options.maxVesselRadiusPx * options.maxVesselRadiusPx);
    const Mask2d vessels = fillSmallHoles(segmentVessels(evidence), smallestLoopPx);
    const Mask2d background = findBackgroundBetweenVessels(vessels, evidence, detected.opacity, clutter.scales(), unit);
    Mask2d completed;
    runInParallel([&] { completed = completeVessels(vessels, background, evidence, smallestLoopPx); },
                  [&] {
                      const float top = saturationLevel(clear);
                      detected.clutter = clutterLevel / static_cast<double>(top);
                      detected.vesselness = normalized(std::move(clear), top);
                  });
    detected.paths =
        orderCurves(extractVesselBranches(completed, evidence, detected.opacity, detected.fieldMask, options),
                    crossingInRadii * options.maxVesselRadiusPx);
    return detected;
}

void addSuspects(AngiogramTrace& trace, const std::vector<int>& ids)
{
    std::vector<int> suspects;
    std::ranges::set_union(trace.suspectCurves, ids, std::back_inserter(suspects));
    trace.suspectCurves = std::move(suspects);
}

/// Removes the vessel trunk from the suspect curves: unlike a catheter, it has branches and is wider than these.
void unmarkTrunk(AngiogramTrace& trace)
{
    if (const auto trunk = findWidestTrunk(trace.centerline)) {
        std::erase(trace.suspectCurves, *trunk);
    }
}

double contrastOf(const AngiogramTrace& trace)
{
    return contrastScore(trace.centerline, trace.suspectCurves, trace.vesselness, trace.clutter);
}

/// Adds the warning about missing contrast agent; drawn masks have neither clutter nor contrast agent.
void warnAboutContrast(AngiogramTrace& trace)
{
    if (trace.clutter > 0.0 && contrastOf(trace) < minContrast) {
        trace.warnings = {messages::frameWithLittleContrast()};
    }
}

void markStationaryCurves(AngiogramTrace& trace, const Angiogram& run, int frame)
{
    const std::vector<int> stationary = findStationaryCurves(trace.centerline, run.frames, frame, run.polarity);
    if (stationary.empty()) {
        return;
    }
    double length = 0.0;
    double stationaryLength = 0.0;
    for (const Curve2d& curve : trace.centerline.curves) {
        length += curve.lengthPx();
        stationaryLength += std::ranges::binary_search(stationary, curve.id) ? curve.lengthPx() : 0.0;
    }
    const std::vector<int> suspects = trace.suspectCurves;
    addSuspects(trace, stationary);
    const bool isOpacified = contrastOf(trace) >= minContrast;
    trace.isStationary = !isOpacified && stationaryLength >= minStationaryFraction * length;
    if (!isOpacified || stationaryLength > maxStationaryFraction * length) {
        trace.suspectCurves = suspects;
    }
    unmarkTrunk(trace);
}

void markEarlierStructures(AngiogramTrace& trace, const Angiogram& run, int frame)
{
    const EarlierStructures detected = findEarlierStructures(
        trace.centerline, run.frames[static_cast<std::size_t>(frame)], run.frames.front(), run.polarity);
    addSuspects(trace, detected.curveIds);
    unmarkTrunk(trace);
    if (detected.isNearlyAll && contrastOf(trace) < definiteContrast) {   // otherwise opacified from the start
        trace.warnings = {messages::frameWithoutContrastArrival()};
    } else {
        warnAboutContrast(trace);
    }
}

/// Traces a drawn mask without segmentation, like a label image.
Result<AngiogramTrace> traceDrawnMask(Mask2d drawn, const TraceOptions& options)
{
    auto curves = traceMask(drawn, options);
    if (!curves) {
        return curves.error();
    }
    AngiogramTrace trace;
    trace.centerline = std::move(curves).value();
    trace.fieldMask = Mask2d(drawn.width, drawn.height, 255);
    trace.vesselness = ImageF(drawn.width, drawn.height);
    std::ranges::transform(drawn.pixels, trace.vesselness.pixels.begin(),
                           [](std::uint8_t value) { return value != 0 ? 1.0F : 0.0F; });
    trace.vesselMask = std::move(drawn);
    return trace;
}

}   // namespace

Result<AngiogramTrace> traceAngiogram(const ImageF& frame, Polarity polarity, const TraceOptions& requested,
                                      const Mask2d& shutter)
{
    const TraceOptions options = resolveOptions(requested);
    if (const auto problem = problemWith(options)) {
        return Error(*problem);
    }
    if (const auto problem = problemWith(frame)) {
        return Error(*problem);
    }
    if (isReportPage(frame)) {
        return Error(messages::frameIsReportPage());
    }
    if (auto drawn = vesselMaskFromDrawing(frame)) {
        return traceDrawnMask(std::move(*drawn), options);
    }
    const ImageF vesselsDark = withVesselsDark(frame, polarity);
    const WorkingSize size = chooseWorkingSize(frame);
    auto detected = detectVessels(toWorkingSize(vesselsDark, size), options, shutter);
    AngiogramTrace trace;
    trace.fieldMask = fromWorkingSize(detected.fieldMask, size, frame.width, frame.height);
    trace.vesselness = fromWorkingSize(detected.vesselness, size, frame.width, frame.height);
    trace.clutter = detected.clutter;
    const double maxRadiusPx = options.maxVesselRadiusPx / size.factor();
    const ImageF opacity = size.halvings == 0
                               ? std::move(detected.opacity)
                               : flattenBackground(vesselsDark, trace.fieldMask, surroundingsInRadii * maxRadiusPx);
    for (auto& path : detected.paths) {
        path = fromWorkingSize(std::move(path), size);
    }
    trace.centerline.curves = centeredCurves(std::move(detected.paths), opacity, trace.fieldMask, maxRadiusPx);
    if (trace.centerline.curves.empty()) {
        return Error(messages::frameWithoutVessels());
    }
    trace.vesselMask = rasterizeVessels(trace.centerline, frame.width, frame.height);
    trace.suspectCurves = suspectCurves(trace.centerline, std::max(frame.width, frame.height));
    addSuspects(trace, findDevicesFromEdge(trace.centerline, trace.fieldMask));
    unmarkTrunk(trace);
    warnAboutContrast(trace);
    return trace;
}

Result<AngiogramTrace> traceFrame(const Angiogram& run, int frame, const TraceOptions& options)
{
    if (frame < 0 || frame >= run.frameCount()) {
        return Error(messages::frameMissing(frame + 1, run.frameCount()));
    }
    auto traced = traceAngiogram(denoiseFrame(run.frames, frame), run.polarity,
                                 resolveOptions(options, run.cArm, run.width(), run.height()), run.shutter);
    if (!traced) {
        return traced;
    }
    AngiogramTrace trace = std::move(traced).value();
    markStationaryCurves(trace, run, frame);
    if (frame > 0) {
        markEarlierStructures(trace, run, frame);
    }
    return trace;
}

Result<Centerline2d> traceMask(const Mask2d& mask, const TraceOptions& requested)
{
    const TraceOptions options = resolveOptions(requested);
    Centerline2d centerline;
    const SkeletonGraph branches = extractDrawnBranches(mask, options);
    for (const auto& path : orderCurves(branches, crossingInRadii * options.maxVesselRadiusPx)) {
        centerline.curves.push_back(smoothCurve(path, static_cast<int>(centerline.curves.size()) + 1));
    }
    if (centerline.curves.empty()) {
        return Error(
            messages::maskWithoutVessels(Quantity{static_cast<double>(options.minComponentLengthPx), 0, "px"}));
    }
    return centerline;
}

}   // namespace angiopose::core
