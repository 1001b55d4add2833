#include "core/viewing/scan/scan_look.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/viewing/scan/seen_scan.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t sampledVoxels = 60000;
constexpr double vesselPerMm = 1.2;   // a wall hides what is behind it within a few mm
constexpr double bonePerMm = 0.45;
constexpr double tissuePerMm = 0.02;
constexpr double brightShare = 0.985;   // brighter than so many voxels: vessels, where nothing else is known
constexpr double brightestShare = 0.998;
constexpr double weakest = 0.04;   // of the opacities, at strength 0

double strengthFactor(double strength)
{
    return weakest * std::pow(4.0 / weakest, std::clamp(strength, 0.0, 1.0));
}

SeenLevels levelsOfHistogram(const Volume& volume)
{
    std::vector<double> values;
    const std::size_t step = std::max<std::size_t>(1, volume.voxels.size() / sampledVoxels) | 1U;
    for (std::size_t i = 0; i < volume.voxels.size(); i += step) {
        values.push_back(volume.value(i));
    }
    if (values.empty()) {
        return {};
    }
    SeenLevels levels;
    levels.tissue = quantile(values, 0.5);
    levels.wall = quantile(values, brightShare);
    levels.blood = std::max(quantile(values, brightestShare), levels.wall + 1e-3);
    return levels;
}

}   // namespace

double Opacity::at(double value) const
{
    return value < from ? 0.0 : perMm * std::clamp((value - from) / std::max(full - from, 1e-9), 0.0, 1.0);
}

SeenLevels seenLevels(const Volume& volume, std::optional<double> threshold)
{
    if (const auto found = findBloodLevel(volume, patientAxisOrder(volume.geometry), {.threshold = threshold})) {
        const BloodLevel& level = found.value();
        return {level.tissue, level.threshold, level.blood, level.isHu};
    }
    SeenLevels levels = levelsOfHistogram(volume);
    if (threshold) {
        levels.wall = *threshold;
        levels.blood = std::max(levels.blood, *threshold + 1.0);
    }
    return levels;
}

ScanLook lookOf(const SeenLevels& levels, const ScanWish& wish, bool hasKinds)
{
    const double factor = strengthFactor(wish.strength);
    const double contrast = std::max(levels.blood - levels.wall, 1e-3);
    ScanLook look;
    look.soft = wish.soft;
    look.bone = wish.bone;
    look.kinds = wish.kinds;
    look.brightFrom = levels.blood + contrast;
    const double below = 0.25 * std::min(contrast, std::max(levels.wall - levels.tissue, 0.0));
    look.vessels = {levels.wall - below, levels.wall + 0.5 * contrast, vesselPerMm * factor};
    if (wish.preset == ScanPreset::VesselsAndBone) {
        look.rest = levels.isHu ? Opacity{levels.wall, levels.blood, bonePerMm * factor}
                                : Opacity{levels.tissue, levels.wall, tissuePerMm * factor};
    } else if (!hasKinds) {   // whatever is as bright as blood
        look.rest = look.vessels;
        look.soft = wish.kinds.empty() ? wish.soft : wish.kinds.front();
    }
    return look;
}

ScanLook lookOfMask(const ScanWish& wish)
{
    ScanLook look;
    look.kinds = wish.kinds;
    look.vessels = {0.3 * maskValue, 0.6 * maskValue, vesselPerMm * strengthFactor(wish.strength)};
    return look;
}

}   // namespace angiopose::core
