#include "app/document/edit_case.h"

namespace angiopose::app {
namespace {

std::vector<int> thoseIn(const core::VesselTree& tree, std::vector<int> branchIds)
{
    std::erase_if(branchIds, [&tree](int id) { return tree.find(id) == nullptr; });
    return branchIds;
}

/// The pose that goes with another tree: the start pose moves with the tree's centroid, any other stays.
core::RigidTransform poseWith(const RegistrationCase& current, const std::shared_ptr<const core::VesselTree>& tree)
{
    const auto isSame = [](const core::RigidTransform& a, const core::RigidTransform& b) {
        return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
    };
    const auto before = core::startPoseOf(current);
    RegistrationCase wanted = current;
    wanted.tree = tree;
    const auto after = core::startPoseOf(wanted);
    const bool follows = after && (!before || isSame(before.value(), current.cameraFromPatient));
    return follows ? after.value() : current.cameraFromPatient;
}

}   // namespace

std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const RegistrationCase& wanted,
                                             const ui::Words& name)
{
    return std::make_unique<ChangeGeometry>(document, ChangeGeometry::valuesOf(wanted), name);
}

std::unique_ptr<QUndoCommand> editTree(CaseDocument& document, core::VesselTree tree, const ui::Words& name)
{
    const RegistrationCase& current = document.current();
    const auto edited = std::make_shared<const core::VesselTree>(std::move(tree));
    return std::make_unique<EditTree>(
        document,
        EditTree::Values{edited, true, thoseIn(*edited, current.auxiliaryBranchIds),
                         thoseIn(*edited, current.excludedBranchIds), thoseIn(*edited, current.hiddenBranchIds),
                         poseWith(current, edited), std::nullopt},
        name);
}

std::unique_ptr<QUndoCommand> takeTrace(CaseDocument& document, const TracedTree& traced, const ui::Words& name)
{
    const core::RegistrationCase& current = document.current();
    const bool isOfScan = traced.file.path == current.scanFile.path;   // which then lies beside no longer
    return std::make_unique<TraceTree>(document,
                                       TraceTree::Values{traced.file,
                                                         isOfScan ? core::InputFile{} : current.scanFile,
                                                         isOfScan ? std::string() : current.scanSeriesId,
                                                         traced.input,
                                                         traced.lumen,
                                                         traced.tree,
                                                         false,
                                                         {},
                                                         {},
                                                         {},
                                                         poseWith(document.current(), traced.tree),
                                                         std::nullopt},
                                       name);
}

std::unique_ptr<QUndoCommand> showView(CaseDocument& document, const RegistrationCase& wanted, const ui::Words& name)
{
    return std::make_unique<ShowView>(document, ShowView::valuesOf(wanted), name);
}

std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const RegistrationCase& wanted, const ui::Words& name)
{
    return std::make_unique<JoinInputs>(document, JoinInputs::valuesOf(wanted), name);
}

}   // namespace angiopose::app