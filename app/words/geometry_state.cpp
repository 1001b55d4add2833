#include "app/words/geometry_state.h"

#include "core/geometry/geometry_checks.h"
#include "ui/words/message_text.h"

#include <QStringList>

#include <algorithm>

namespace angiopose::app {
namespace {

/// Lists the missing geometry values, one per line, except those that a camera or an initial pose replaces.
QString missingIn(const core::Case& current)
{
    const auto camera = core::cameraOf(current.shown());
    const bool isCameraMissing = !camera;
    const bool isStartMissing = current.vessels.tree && !core::initialPoseOf(current);
    if (!isCameraMissing && !isStartMissing) {
        return {};
    }
    QStringList lines;
    for (const core::Message& message : core::findMissingGeometry(current.shown().geometry.cArm)) {
        lines << ui::messageText(message);
    }
    return lines.isEmpty() && isCameraMissing ? ui::messageText(camera.error().message) : lines.join(QLatin1Char('\n'));
}

}   // namespace

ui::GeometryState geometryState(const core::Case& current)
{
    ui::GeometryState state;
    state.cArm = current.shown().geometry.cArm;
    state.cameraOverride = current.shown().geometry.cameraOverride;
    if (current.vessels.tree) {
        state.vesselCentroidMm = core::centroidInPatient(*current.vessels.tree);
    }
    if (!current.shown().angiogram) {
        return state;
    }
    const core::Angiogram& angiogram = *current.shown().angiogram;
    state.headerTags = angiogram.gantry.tags;
    state.imageSizePx = {angiogram.width(), angiogram.height()};
    const auto frame = static_cast<std::size_t>(std::max(0, current.shown().frame));
    if (frame < angiogram.gantry.angleIncrementsDeg.size()) {
        state.gantryRotationDeg = angiogram.gantry.angleIncrementsDeg[frame];
    }
    state.missing = missingIn(current);
    state.contradictions = core::contradictionsOf(current.shown());
    if (const auto camera = core::cameraOf(current.shown()); camera && state.vesselCentroidMm) {
        const double depthMm = (current.shown().cameraFromPatient * *state.vesselCentroidMm).z();
        if (depthMm > core::minProjectableDepthMm) {
            state.vesselMmPerPx = core::millimetersPerPixel(camera.value(), depthMm);
        }
    }
    return state;
}

}   // namespace angiopose::app
