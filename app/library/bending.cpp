#include "angiopose/bending.h"

#include "app/library/conversions.h"
#include "app/library/relay.h"
#include "core/registration/deformable/bent_tree.h"

namespace angiopose::library {
namespace {

BendVerdict publicVerdict(core::BendVerdict verdict)
{
    switch (verdict) {
        case core::BendVerdict::Bent:
            return BendVerdict::Bent;
        case core::BendVerdict::Unsure:
            return BendVerdict::Unsure;
        default:
            return BendVerdict::Rigid;
    }
}

/// The motions of all branches, row by row as the points of the tree.
void appendMotions(const core::VesselTree& tree, const core::DeformableResult& bent, BentVessels& converted)
{
    for (const core::VesselBranch& branch : tree.branches) {
        const core::BranchMotion& motion = *core::motionOf(bent, branch.id);
        converted.displacementMm.insert(converted.displacementMm.end(), motion.displacementMm.begin(),
                                        motion.displacementMm.end());
        converted.covarianceMm2.insert(converted.covarianceMm2.end(), motion.covariance.begin(),
                                       motion.covariance.end());
        converted.seenShare.insert(converted.seenShare.end(), motion.displacementMm.size(), motion.seenShare);
    }
}

}   // namespace

BentVessels toPublic(const core::DeformableResult& bent, const core::VesselTree& tree)
{
    BentVessels converted;
    converted.verdict = publicVerdict(bent.verdict);
    converted.tree = toPublic(core::bentTree(tree, bent));
    appendMotions(tree, bent, converted);
    for (const core::RigidTransform& pose : bent.viewPoses) {
        converted.viewPoses.push_back(toPublic(pose));
    }
    converted.logEvidenceGain = bent.logEvidenceGain;
    converted.meanMotionMm = bent.meanMotionMm;
    converted.largestMotionMm = bent.largestMotionMm;
    converted.spreadMm = bent.spreadMm;
    converted.placeStdMm = bent.placeStdMm;
    converted.rigidOffMm = bent.rigid.meanMm;
    converted.rigidOffMostMm = bent.rigid.farthestMm;
    converted.rigidOffMostAtBranch = bent.rigid.farthestBranchId;
    converted.explainedShare = bent.explainedShare;
    converted.noisePx = bent.noisePx;
    converted.messages = toPublic(bent.messages);
    return converted;
}

}   // namespace angiopose::library

namespace angiopose {

std::string toText(BendVerdict verdict)
{
    for (const core::BendVerdict each :
         {core::BendVerdict::Rigid, core::BendVerdict::Bent, core::BendVerdict::Unsure}) {
        if (library::publicVerdict(each) == verdict) {
            return std::string(core::toText(each));
        }
    }
    return {};
}

}   // namespace angiopose
