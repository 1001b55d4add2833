// Display part of MarkController: list rows, marks in every view, and handles of the modes.
#include "app/editing/mark_controller.h"
#include "app/words/mark_words.h"
#include "app/words/measure_words.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

using core::ImageAnnotation;
using core::TargetObservation;
using core::VesselMark;
using core::VesselMarkKind;
using ui::MarkMode;

namespace {

constexpr std::size_t ringSteps3d = 48;

}   // namespace

std::vector<ui::MarkRow> MarkController::rows() const
{
    std::vector<ui::MarkRow> rows;
    const auto checked = core::evaluateTargetPoints(current(), poseOf());
    for (const VesselMark& mark : marks()) {
        rows.push_back(markRow(mark, checked, current().shownView));
    }
    for (const ImageAnnotation& annotation : current().shown().annotations) {
        rows.push_back(annotationRow(annotation));
    }
    return rows;
}

void MarkController::show()
{
    const auto list = rows();
    ui_.panel.showMarks(list, list.empty()
                                  ? tr("Named points on the vessels, with the distance between their projection and "
                                       "their position in the image; arrows and text annotations for exported images.")
                                  : QString());
    showVesselMarks();
    showHandles();
}

void MarkController::showVesselMarks()
{
    MarkedView placed{current(), current().shownView, sync_.shownFrame(), preview_.shape(), poseOf()};
    for (const int row : ui_.panel.selectedRows()) {
        const auto count = static_cast<int>(marks().size());
        (row < count ? placed.selectedMarks : placed.selectedAnnotations).insert(row < count ? row : row - count);
    }
    ui_.view.setPlacedMarks(windowPlacedMarks(placed));
    std::vector<ui::TreeMark> signs;
    for (const VesselMark& mark :
         marksOnDrawnVessels(current().shown(), current().vessels, preview_.pose(), preview_.shape())) {
        const bool isRing = mark.kind == VesselMarkKind::OstiumRing;
        signs.push_back({mark.pointInPatient,
                         isRing ? core::ringPoints(mark, ringSteps3d) : std::vector<Eigen::Vector3d>{},
                         QString::fromStdString(mark.name)});
    }
    ui_.treeView.showVesselMarks(std::move(signs));
    std::vector<ui::SliceMark> places;
    for (const VesselMark& mark : marks()) {
        const bool isRing = mark.kind == VesselMarkKind::OstiumRing;
        places.push_back({mark.pointInPatient, QString::fromStdString(mark.name),
                          isRing ? core::ringPoints(mark, ringSteps3d) : std::vector<Eigen::Vector3d>{}});
    }
    ui_.slices.setPoints(ui::SliceMarkKind::Place, std::move(places));
}

void MarkController::showHandles()
{
    std::array<std::vector<Eigen::Vector2d>, ui::markModeCount> places;
    handles_ = {};
    const auto take = [&](MarkMode mode, const Handle& handle, const Eigen::Vector2d& pixel) {
        handles_[static_cast<std::size_t>(mode)].push_back(handle);
        places[static_cast<std::size_t>(mode)].push_back(pixel);
    };
    const int frame = sync_.shownFrame();
    const auto drawn = marksOnDrawnVessels(current().shown(), current().vessels, preview_.pose(), preview_.shape());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const bool isRing = drawn[i].kind == VesselMarkKind::OstiumRing;
        const auto at = core::project(ui_.view.camera(), preview_.pose() * drawn[i].pointInPatient);
        const auto seen = std::ranges::find_if(current().shown().observations, [&](const TargetObservation& each) {
            return each.markId == drawn[i].id && each.frame == frame;
        });
        if (at && ui_.view.camera().width > 0) {
            take(isRing ? MarkMode::OstiumRing : MarkMode::TargetPoint, {i, 0}, *at);
        }
        if (!isRing && seen != current().shown().observations.end()) {
            take(MarkMode::TargetInImage, {i, 0}, seen->pixel);
        } else if (!isRing && at && ui_.view.camera().width > 0) {
            take(MarkMode::TargetInImage, {i, 0}, *at);   // the handle is dragged to the point's image position
        }
    }
    const std::vector<ImageAnnotation>& annotations = current().shown().annotations;
    for (std::size_t i = 0; i < annotations.size(); ++i) {
        for (std::size_t p = 0; p < annotations[i].pixels.size() && annotations[i].frame == frame; ++p) {
            take(annotations[i].kind == core::AnnotationKind::Arrow ? MarkMode::Arrow : MarkMode::Text, {i, p},
                 annotations[i].pixels[p]);
        }
    }
    for (std::size_t mode = 0; mode < ui::markModeCount; ++mode) {
        tools_[mode]->showHandles(std::move(places[mode]));
    }
}

}   // namespace angiopose::app
