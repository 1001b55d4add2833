#include "core/registration/judging/followed_vessels.h"

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/alignment_points.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr int bridgedPoints = 2;   // maximum number of mismatched points bridged within a matched stretch

/// Accumulates the matched stretches along one branch.
class BranchWalk {
public:
    void step(double lengthMm, bool isInView, bool agrees)
    {
        if (!isInView) {
            endRun();
            return;
        }
        inViewMm_ += lengthMm;
        if (agrees) {
            runMm_ += lengthMm + gapMm_;
            gapMm_ = 0.0;
            gapPoints_ = 0;
        } else if (runMm_ > 0.0 && gapPoints_ < bridgedPoints) {
            gapMm_ += lengthMm;
            ++gapPoints_;
        } else {
            endRun();
        }
    }

    void addTo(FollowedVessels& sum)
    {
        endRun();
        sum.inViewMm += inViewMm_;
        sum.followedMm += followedMm_;
        sum.branchesInView += inViewMm_ >= minStretchMm ? 1 : 0;
        sum.branchesFollowed += inViewMm_ >= minStretchMm && followedMm_ >= 0.5 * inViewMm_ ? 1 : 0;
    }

private:
    void endRun()
    {
        followedMm_ += runMm_ >= minStretchMm ? runMm_ : 0.0;
        runMm_ = gapMm_ = 0.0;
        gapPoints_ = 0;
    }

    double inViewMm_ = 0.0;
    double followedMm_ = 0.0;
    double runMm_ = 0.0;
    double gapMm_ = 0.0;
    int gapPoints_ = 0;
};

}   // namespace

FollowedVessels followedVessels(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const ProjectedTree& projected)
{
    const TreeSamples& tree = problem.tree;
    std::vector<double> residuals;   // NaN if no vessel with a similar direction is near
    Alignment(alignmentPoints(tree), problem.camera, target)
        .collectResiduals(aboutCentroid(cameraFromPatient, tree.centroid), matchTolerancePx, residuals);
    FollowedVessels sum;
    BranchWalk walk;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const bool begins = i == 0 || tree.branchIndex[i] != tree.branchIndex[i - 1];
        if (begins) {
            walk.addTo(sum);
            walk = {};
        }
        const double lengthMm = begins ? 0.0 : (tree.points[i] - tree.points[i - 1]).norm();
        walk.step(lengthMm, projected.isInView[i] != 0, !std::isnan(residuals[i]));
    }
    walk.addTo(sum);
    return sum;
}

}   // namespace angiopose::core
