#include "core/tracing/angiogram/drawing/drawing_ground.h"

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

constexpr std::size_t groundSamples = 200000;
constexpr double groundInRadii = 3.0;

}   // namespace

DrawingGround drawingGround(const ImageF& frame, Polarity polarity, const TraceOptions& asked, const Mask2d& shutter)
{
    const TraceOptions options = settledFor(asked);
    const auto isFinite = [](float value) { return std::isfinite(value); };
    if (frame.isEmpty() || !std::ranges::all_of(frame.pixels, isFinite)) {
        return {};
    }
    ImageF vesselsDark = frame;
    if (polarity == Polarity::VesselsBright) {
        std::ranges::transform(vesselsDark.pixels, vesselsDark.pixels.begin(), std::negate<>());
    }
    DrawingGround ground;
    ground.fieldMask = findField(vesselsDark, 2.0 * options.maxVesselRadiusPx, shutter);
    const Mask2d text = burnedInText(vesselsDark);
    for (std::size_t i = 0; i < text.pixels.size(); ++i) {
        ground.fieldMask.pixels[i] = text.pixels[i] != 0 ? 0 : ground.fieldMask.pixels[i];
    }
    ground.opacity = flattenBackground(vesselsDark, ground.fieldMask, groundInRadii * options.maxVesselRadiusPx);
    ground.vesselness = ridgeStrength(ground.opacity, options.minVesselRadiusPx, options.maxVesselRadiusPx);
    // The strongest 0.1 % of the values saturate at 1.
    const float top = std::max(ranked(evenSample(ground.vesselness.pixels, groundSamples), 0.999), 1e-12F);
    for (float& value : ground.vesselness.pixels) {
        value = std::min(1.0F, value / top);
    }
    return ground;
}

}   // namespace angiopose::core
