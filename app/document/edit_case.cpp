#include "app/document/edit_case.h"

namespace angiopose::app {
namespace {

/// Replaces the vessels: an initial pose moves with the centroid of the tree; any other pose stays.
std::unique_ptr<QUndoCommand> changeVessels(CaseDocument& document, Vessels vessels, const ui::LocalizedText& name)
{
    const auto isSame = [](const core::RigidTransform& a, const core::RigidTransform& b) {
        return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
    };
    const View& shown = document.current().shown();
    const auto before = core::initialPoseOf(document.current());
    const auto after = core::initialPoseOf(shown, vessels);
    const bool follows = after && (!before || isSame(before.value(), shown.cameraFromPatient));
    std::vector<View> views = removeResults(document.current().views);
    if (follows) {
        views[document.current().shownView].cameraFromPatient = after.value();
    }
    return std::make_unique<ChangeVessels>(document, ChangeVessels::Values{std::move(vessels), std::move(views)}, name);
}

}   // namespace

std::vector<View> removeResults(std::vector<View> views)
{
    for (View& view : views) {
        core::discardResults(view);
    }
    return views;
}

std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const Case& newCase, const ui::LocalizedText& name)
{
    return std::make_unique<ChangeGeometry>(document, ChangeGeometry::valuesOf(newCase), name);
}

std::unique_ptr<QUndoCommand> editTree(CaseDocument& document, core::VesselTree tree, const ui::LocalizedText& name)
{
    Vessels vessels = document.current().vessels;
    const auto edited = std::make_shared<const core::VesselTree>(std::move(tree));
    for (std::vector<int>* ids : {&vessels.auxiliaryBranchIds, &vessels.excludedBranchIds, &vessels.hiddenBranchIds}) {
        std::erase_if(*ids, [&edited](int id) { return edited->find(id) == nullptr; });
    }
    vessels.tree = edited;
    vessels.isTreeEdited = true;
    return changeVessels(document, std::move(vessels), name);
}

std::unique_ptr<QUndoCommand> applyTrace(CaseDocument& document, const TracedTree& traced,
                                         const ui::LocalizedText& name)
{
    Vessels vessels = document.current().vessels;
    const bool isEdited = traced.lumenOrigin == LumenOrigin::Edited;
    if (isEdited &&
        vessels.input.kind == core::VesselInputKind::Volume) {   // the scan stays linked, since the mask lies in it
        vessels.scanFile = vessels.file;
        vessels.scanSeriesId = vessels.input.seriesId;
    } else if (!isEdited &&
               traced.file.path ==
                   vessels.scanFile.path) {   // the traced scan is the vessel input and no longer a separate scan
        vessels.scanFile = {};
        vessels.scanSeriesId.clear();
    }
    vessels.file = traced.file;
    vessels.input = traced.input;
    vessels.lumen = traced.lumen;
    vessels.tree = traced.tree;
    vessels.isLumenEdited = isEdited;
    vessels.isTreeEdited = false;
    vessels.auxiliaryBranchIds.clear();
    vessels.excludedBranchIds.clear();
    vessels.hiddenBranchIds.clear();
    return changeVessels(document, std::move(vessels), name);
}

std::unique_ptr<QUndoCommand> showView(CaseDocument& document, const Case& newCase, const ui::LocalizedText& name)
{
    return std::make_unique<ShowView>(document, ShowView::valuesOf(newCase), name);
}

std::unique_ptr<QUndoCommand> addInputs(CaseDocument& document, const Case& newCase, const ui::LocalizedText& name)
{
    return std::make_unique<AddInputs>(document, AddInputs::valuesOf(newCase), name);
}

}   // namespace angiopose::app
