#include "app/texts/image_marks.h"

#include "core/measuring/measure_image.h"

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr std::size_t ringSteps = 72;

std::optional<std::vector<Eigen::Vector2d>> outlineOf(const core::VesselMark& ring,
                                                      const core::PosedCamera& posedCamera)
{
    std::vector<Eigen::Vector2d> outline;
    for (const Eigen::Vector3d& point : core::ringPoints(ring, ringSteps)) {
        const auto pixel = core::project(posedCamera.camera, posedCamera.cameraFromPatient * point);
        if (!pixel) {
            return std::nullopt;
        }
        outline.push_back(*pixel);
    }
    return outline;
}

/// Adds the observed position of a mark in the frame, with a line to the position where the mark is drawn.
void addObservations(std::vector<ui::ImageMark>& marks, const MarkedView& placed, int markId,
                     const std::optional<Eigen::Vector2d>& drawnAt)
{
    for (const core::TargetObservation& seen : placed.session.views[placed.view].observations) {
        if (seen.markId != markId || seen.frame != placed.frame) {
            continue;
        }
        if (drawnAt) {
            marks.push_back({ui::MarkShape::Line, {*drawnAt, seen.pixel}, {}, false, ui::MarkTone::Place});
        }
        marks.push_back({ui::MarkShape::Cross, {seen.pixel}, {}, false, ui::MarkTone::Place});
    }
}

std::string labelOf(const MarkedView& placed, const core::VesselMark& mark,
                    const std::function<std::string(const core::Message&)>& toText,
                    const std::vector<core::TargetPointResult>& checked)
{
    const auto found = std::ranges::find(
        checked, mark.id, [](const core::TargetPointResult& checkedPoint) { return checkedPoint.mark.id; });
    const auto words = found == checked.end() ? std::nullopt : core::labelOf(*found, placed.view);
    return words ? mark.name + (mark.name.empty() ? "" : ": ") + toText(*words) : mark.name;
}

void addAnnotations(std::vector<ui::ImageMark>& marks, const MarkedView& placed)
{
    const std::vector<core::ImageAnnotation>& all = placed.session.views[placed.view].annotations;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].frame == placed.frame) {
            const bool isArrow = all[i].kind == core::AnnotationKind::Arrow;
            marks.push_back({isArrow ? ui::MarkShape::Arrow : ui::MarkShape::Text, all[i].pixels, all[i].text,
                             placed.selectedAnnotations.contains(static_cast<int>(i))});
        }
    }
}

ui::MarkShape shapeOfMark(core::MeasurementKind kind)
{
    switch (kind) {
        case core::MeasurementKind::Length:
            return ui::MarkShape::Length;
        case core::MeasurementKind::Angle:
            return ui::MarkShape::Angle;
        case core::MeasurementKind::Area:
            break;
    }
    return ui::MarkShape::Outline;
}

}   // namespace

std::vector<core::VesselMark> marksOnDrawnVessels(const core::View& view, const core::Vessels& vessels,
                                                  const core::RigidTransform& pose, VesselShape shape)
{
    std::vector<core::VesselMark> marks = vessels.marks;
    if (marks.empty() || shape == VesselShape::Rigid || !deformationForPose(view, vessels, pose)) {
        return marks;
    }
    const core::VesselTree deformed = vesselsToDraw(view, vessels, pose, shape).tree;
    for (core::VesselMark& mark : marks) {
        mark = core::moveWithVessels(*vessels.tree, deformed, std::move(mark));
    }
    return marks;
}

std::vector<ui::ImageMark> placedMarks(const MarkedView& placed,
                                       const std::function<std::string(const core::Message&)>& toText)
{
    const core::View& view = placed.session.views[placed.view];
    std::vector<ui::ImageMark> marks;
    const auto camera = core::cameraOf(view);
    if (camera && !placed.session.vessels.marks.empty()) {
        const core::RigidTransform pose = placed.poseOf ? placed.poseOf(placed.view) : view.cameraFromPatient;
        const auto checked = placed.poseOf ? core::evaluateTargetPoints(placed.session, placed.poseOf)
                                           : core::evaluateTargetPoints(placed.session);
        const auto drawn = marksOnDrawnVessels(view, placed.session.vessels, pose, placed.shape);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const core::VesselMark& mark = drawn[i];
            const bool isSelected = placed.selectedMarks.contains(static_cast<int>(i));
            const auto at = core::project(camera.value(), pose * mark.pointInPatient);
            const std::string label = labelOf(placed, mark, toText, checked);
            if (mark.kind == core::VesselMarkKind::OstiumRing) {
                if (auto outline = outlineOf(mark, {camera.value(), pose})) {
                    marks.push_back(
                        {ui::MarkShape::Outline, std::move(*outline), label, isSelected, ui::MarkTone::Place});
                }
                continue;
            }
            addObservations(marks, placed, mark.id, at);
            if (at) {
                marks.push_back({ui::MarkShape::Point, {*at}, label, isSelected, ui::MarkTone::Place});
            }
        }
    }
    addAnnotations(marks, placed);
    return marks;
}

std::vector<ui::ImageMark> marksOf(const core::MeasurementContext& seen, int frame,
                                   const std::function<std::string(const core::Message&)>& toText)
{
    std::vector<ui::ImageMark> marks;
    for (const core::ImageMeasurement& measurement : seen.view.measurements) {
        if (measurement.frame != frame) {
            continue;
        }
        const auto measured = core::measureImage(measurement, seen);
        const std::string value = measured ? toText(core::labelOf(measured.value(), measurement.kind)) : "–";
        const std::string label = measurement.name.empty() ? value : measurement.name + " " + value;
        marks.push_back({shapeOfMark(measurement.kind), measurement.pixels, label});
    }
    return marks;
}

}   // namespace angiopose::app
