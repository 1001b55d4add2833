#include "core/tracing/angiogram/drawing/drawing_guide.h"

#include "core/imaging/gray_statistics.h"
#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "core/tracing/angiogram/frame/field_mask.h"
#include "core/tracing/angiogram/frame/flatten_background.h"
#include "core/tracing/angiogram/frame/widest_vessel.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace angiopose::core {
namespace {

constexpr std::size_t guideSamples = 200000;
constexpr double guideReachInRadii = 3.0;

}   // namespace

DrawingGuide computeDrawingGuide(const ImageF& frame, Polarity polarity, const TraceOptions& requested,
                                 const Mask2d& shutter)
{
    const TraceOptions options = resolveOptions(requested);
    const auto isFinite = [](float value) { return std::isfinite(value); };
    if (frame.isEmpty() || !std::ranges::all_of(frame.pixels, isFinite)) {
        return {};
    }
    ImageF vesselsDark = frame;
    if (polarity == Polarity::VesselsBright) {
        std::ranges::transform(vesselsDark.pixels, vesselsDark.pixels.begin(), std::negate<>());
    }
    DrawingGuide guide;
    guide.fieldMask = findField(vesselsDark, 2.0 * options.maxVesselRadiusPx, shutter);
    const Mask2d text = burnedInTextMask(vesselsDark);
    for (std::size_t i = 0; i < text.pixels.size(); ++i) {
        guide.fieldMask.pixels[i] = text.pixels[i] != 0 ? 0 : guide.fieldMask.pixels[i];
    }
    guide.opacity = flattenBackground(vesselsDark, guide.fieldMask, guideReachInRadii * options.maxVesselRadiusPx);
    guide.vesselness = ridgeStrength(guide.opacity, options.minVesselRadiusPx, options.maxVesselRadiusPx);
    // The strongest 0.1 % of the values saturate at 1.
    const float top = std::max(grayQuantile(subsample(guide.vesselness.pixels, guideSamples), 0.999), 1e-12F);
    for (float& value : guide.vesselness.pixels) {
        value = std::min(1.0F, value / top);
    }
    return guide;
}

}   // namespace angiopose::core
