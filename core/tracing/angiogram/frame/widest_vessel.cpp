#include "core/tracing/angiogram/frame/widest_vessel.h"

#include "core/tracing/angiogram/frame/working_size.h"

#include <algorithm>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr double leftMainRadiusMm = 2.5;
constexpr double maxRadiusPx = 24.0;   // a larger radius would also pick up ribs and spine

}   // namespace

double widestVesselRadiusPx(const CArm& cArm, int width, int height)
{
    const double spacingMm = cArm.columnSpacingMm.value.value_or(0.0);
    if (!(spacingMm > 0.0)) {
        return defaultMaxVesselRadiusPx;
    }
    const auto& [sidMm, sodMm] = std::tie(cArm.sourceToDetectorMm.value, vesselDepthOf(cArm).value);
    const double magnification = sidMm && sodMm && *sodMm > 0.0 ? std::clamp(*sidMm / *sodMm, 1.0, 2.5) : 1.0;
    const double storedPx = leftMainRadiusMm * magnification / spacingMm;
    return std::clamp(storedPx * chooseWorkingSize(width, height).factor(), defaultMaxVesselRadiusPx, maxRadiusPx);
}

TraceOptions resolveOptions(TraceOptions options, const CArm& cArm, int width, int height)
{
    if (options.maxVesselRadiusPx == 0.0) {
        options.maxVesselRadiusPx = widestVesselRadiusPx(cArm, width, height);
    }
    return options;
}

}   // namespace angiopose::core
