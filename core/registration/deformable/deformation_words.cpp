#include "core/registration/deformable/deformation_words.h"

#include "core/messages/messages.h"
#include "core/registration/deformable/motion_of_tree.h"
#include "core/registration/deformable/moved_part.h"

#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double convincingGain = 10.0;   // log evidence
constexpr double greatestSpreadMm = 0.5;   // larger differences mean that the runs match different branches
constexpr double minExplained = 0.4;   // fraction of the visible tree
constexpr double greatestResidualPx = 1.2;   // more than tracing noise explains: motion that was not captured

Message sideWord(const Eigen::Vector3d& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const bool isUp = direction[axis] > 0.0;
    switch (axis) {
        case 0:
            return isUp ? messages::sideLeft() : messages::sideRight();
        case 1:
            return isUp ? messages::sideBack() : messages::sideFront();
        default:
            return isUp ? messages::sideHead() : messages::sideFeet();
    }
}

void keepRigid(std::span<const DeformableView> views, DeformableResult& result)
{
    DeformableResult rigid = rigidResult(views);
    for (std::size_t b = 0; b < rigid.branches.size(); ++b) {
        result.branches[b].displacementMm = std::move(rigid.branches[b].displacementMm);
    }
    result.cameraFromPatient = rigid.cameraFromPatient;
    result.viewPoses = std::move(rigid.viewPoses);
    result.largestMotionMm = 0.0;
    result.meanMotionMm = 0.0;
}

}   // namespace

void judgeDeformation(std::span<const DeformableView> views, DeformableResult& result)
{
    if (result.stopReason == StopReason::StoppedByUser) {
        result.verdict = DeformationVerdict::Unsure;
        result.messages.push_back(messages::deformationStopped());
        return;
    }
    const bool isSure = result.spreadMm <= greatestSpreadMm && result.explainedShare >= minExplained &&
                        result.noisePx <= greatestResidualPx;
    if (result.spreadMm > greatestSpreadMm) {
        result.messages.push_back(messages::deformationRunsDiffer(inMm(result.spreadMm, 1)));
    }
    if (result.explainedShare < minExplained) {
        result.messages.push_back(messages::deformationLittleSeen(Quantity{100.0 * result.explainedShare, 0, "%"}));
    }
    if (result.logEvidenceGain < convincingGain) {
        result.verdict = DeformationVerdict::Rigid;
        keepRigid(views, result);
        return;
    }
    result.verdict = isSure ? DeformationVerdict::Deformed : DeformationVerdict::Unsure;
    if (result.noisePx > greatestResidualPx) {
        result.messages.push_back(messages::deformationNotFollowed(Quantity{result.noisePx, 1, "px"}));
    }
    if (const auto part = movedPart(views.front().input.tree, result)) {
        result.messages.push_back(messages::deformationPartMoved(sideWord(part->side),
                                                                 Quantity{100.0 * part->share, 0, "%"},
                                                                 inMm(part->shift.norm(), 1), sideWord(part->shift))
                                      .as(Severity::Note));
    }
    if (views.size() == 1) {
        result.messages.push_back(messages::deformationDepthUnknown().as(Severity::Note));
    }
}

std::string_view toText(DeformationVerdict verdict)
{
    switch (verdict) {
        case DeformationVerdict::Rigid:
            return "rigid";
        case DeformationVerdict::Deformed:
            return "bent";
        case DeformationVerdict::Unsure:
            return "unsure";
    }
    return "";
}

}   // namespace angiopose::core
