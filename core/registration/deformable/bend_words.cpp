#include "core/registration/deformable/bend_words.h"

#include "core/messages/says.h"
#include "core/registration/deformable/motion_of_tree.h"
#include "core/registration/deformable/moved_part.h"

#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double convincingGain = 10.0;   // log evidence
constexpr double greatestSpreadMm = 0.5;   // runs that differ more follow other branches
constexpr double leastExplained = 0.4;   // of the visible tree
constexpr double greatestResidualPx = 1.2;   // beyond what tracing explains: motion that was not followed

Message sideWord(const Eigen::Vector3d& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const bool isUp = direction[axis] > 0.0;
    switch (axis) {
        case 0:
            return isUp ? says::sideLeft() : says::sideRight();
        case 1:
            return isUp ? says::sideBack() : says::sideFront();
        default:
            return isUp ? says::sideHead() : says::sideFeet();
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

void judgeBend(std::span<const DeformableView> views, DeformableResult& result)
{
    if (result.stopReason == StopReason::StoppedByUser) {
        result.verdict = BendVerdict::Unsure;
        result.messages.push_back(says::bendStopped());
        return;
    }
    const bool isSure = result.spreadMm <= greatestSpreadMm && result.explainedShare >= leastExplained &&
                        result.noisePx <= greatestResidualPx;
    if (result.spreadMm > greatestSpreadMm) {
        result.messages.push_back(says::bendRunsDiffer(inMm(result.spreadMm, 1)));
    }
    if (result.explainedShare < leastExplained) {
        result.messages.push_back(says::bendLittleSeen(Quantity{100.0 * result.explainedShare, 0, "%"}));
    }
    if (result.logEvidenceGain < convincingGain) {
        result.verdict = BendVerdict::Rigid;
        keepRigid(views, result);
        return;
    }
    result.verdict = isSure ? BendVerdict::Bent : BendVerdict::Unsure;
    if (result.noisePx > greatestResidualPx) {
        result.messages.push_back(says::bendNotFollowed(Quantity{result.noisePx, 1, "px"}));
    }
    if (const auto part = movedPart(views.front().input.tree, result)) {
        result.messages.push_back(says::bendPartMoved(sideWord(part->side), Quantity{100.0 * part->share, 0, "%"},
                                                      inMm(part->shift.norm(), 1), sideWord(part->shift))
                                      .as(Severity::Note));
    }
    if (views.size() == 1) {
        result.messages.push_back(says::bendDepthUnknown().as(Severity::Note));
    }
}

std::string_view toText(BendVerdict verdict)
{
    switch (verdict) {
        case BendVerdict::Rigid:
            return "rigid";
        case BendVerdict::Bent:
            return "bent";
        case BendVerdict::Unsure:
            return "unsure";
    }
    return "";
}

}   // namespace angiopose::core
