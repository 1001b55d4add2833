#include "core/tracing/angiogram/evidence/judged_evidence.h"

#include "core/imaging/grey_statistics.h"
#include "core/imaging/image_filters.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr float leastCertain = 0.01F;   // no answer of the network is surer than this
constexpr float oddsPower = 0.3F;
constexpr float usualFactor = 0.55F;
constexpr float leastRidge = 0.3F;   // where the network sees a vessel that hardly is a ridge
constexpr float sureOfVessel = 0.7F;   // it draws vessels too wide at a half
constexpr double mostlyDevice = 0.5;

}   // namespace

ImageF withGreyOutside(ImageF frame, const Mask2d& field)
{
    std::vector<float> inside;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (field.pixels[i] != 0) {
            inside.push_back(frame.pixels[i]);
        }
    }
    const float middle = inside.empty() ? 0.0F : ranked(std::move(inside), 0.5);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        frame.pixels[i] = field.pixels[i] != 0 ? frame.pixels[i] : middle;
    }
    return frame;
}

ImageF judgedEvidence(ImageF evidence, const ImageF& vesselProbability, const Mask2d& field)
{
    for (std::size_t i = 0; i < evidence.pixels.size(); ++i) {
        if (field.pixels[i] != 0) {
            const float p = std::clamp(vesselProbability.pixels[i], leastCertain, 1.0F - leastCertain);
            const float odds = std::pow(p / (1.0F - p), oddsPower);
            evidence.pixels[i] = usualFactor * odds * std::max(evidence.pixels[i], leastRidge);
        }
    }
    return evidence;
}

Mask2d likelyVessels(const ImageF& vesselProbability, const Mask2d& field)
{
    Mask2d mask(field.width, field.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] = field.pixels[i] != 0 && vesselProbability.pixels[i] > sureOfVessel ? 255 : 0;
    }
    return mask;
}

std::vector<int> deviceCurves(const Centerline2d& centerline, const FrameClasses& classes, double factor)
{
    std::vector<int> devices;
    for (const Curve2d& curve : centerline.curves) {
        const auto count =
            std::count_if(curve.pointsPx.begin(), curve.pointsPx.end(), [&](const Eigen::Vector2d& point) {
                const Eigen::Vector2d at = (point.array() + 0.5) * factor - 0.5;   // pixel centres are whole numbers
                return sampled(classes.device, at.x(), at.y()) > sampled(classes.vessel, at.x(), at.y());
            });
        if (static_cast<double>(count) > mostlyDevice * static_cast<double>(curve.pointsPx.size())) {
            devices.push_back(curve.id);
        }
    }
    return devices;
}

}   // namespace angiopose::core
