#include "angiopose/deformation.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/registration/deformable/deformed_tree.h"

namespace angiopose::library {
namespace {

DeformationVerdict publicVerdict(core::DeformationVerdict verdict)
{
    switch (verdict) {
        case core::DeformationVerdict::Deformed:
            return DeformationVerdict::Deformed;
        case core::DeformationVerdict::Unsure:
            return DeformationVerdict::Unsure;
        default:
            return DeformationVerdict::Rigid;
    }
}

/// Appends the displacements of all branches, one row per point of the tree.
void appendMotions(const core::VesselTree& tree, const core::DeformableResult& deformed, DeformedVessels& converted)
{
    for (const core::VesselBranch& branch : tree.branches) {
        const core::BranchMotion& motion = *core::findMotion(deformed, branch.id);
        converted.displacementMm.insert(converted.displacementMm.end(), motion.displacementMm.begin(),
                                        motion.displacementMm.end());
        converted.covarianceMm2.insert(converted.covarianceMm2.end(), motion.covariance.begin(),
                                       motion.covariance.end());
        converted.seenShare.insert(converted.seenShare.end(), motion.displacementMm.size(), motion.seenShare);
    }
}

}   // namespace

DeformedVessels toPublic(const core::DeformableResult& deformed, const core::VesselTree& tree)
{
    DeformedVessels converted;
    converted.verdict = publicVerdict(deformed.verdict);
    converted.tree = toPublic(core::deformedTree(tree, deformed));
    appendMotions(tree, deformed, converted);
    for (const core::RigidTransform& pose : deformed.viewPoses) {
        converted.viewPoses.push_back(toPublic(pose));
    }
    converted.logEvidenceGain = deformed.logEvidenceGain;
    converted.meanMotionMm = deformed.meanMotionMm;
    converted.largestMotionMm = deformed.largestMotionMm;
    converted.spreadMm = deformed.spreadMm;
    converted.placeStdMm = deformed.placeStdMm;
    converted.rigidOffMm = deformed.rigid.meanMm;
    converted.rigidOffMostMm = deformed.rigid.farthestMm;
    converted.rigidOffMostAtBranch = deformed.rigid.farthestBranchId;
    converted.explainedShare = deformed.explainedShare;
    converted.noisePx = deformed.noisePx;
    converted.messages = toPublic(deformed.messages);
    return converted;
}

}   // namespace angiopose::library

namespace angiopose {

std::string toText(DeformationVerdict verdict)
{
    for (const core::DeformationVerdict each :
         {core::DeformationVerdict::Rigid, core::DeformationVerdict::Deformed, core::DeformationVerdict::Unsure}) {
        if (library::publicVerdict(each) == verdict) {
            return std::string(core::toText(each));
        }
    }
    return {};
}

}   // namespace angiopose
