#include "core/simulation/tree_takeoffs.h"

#include "core/simulation/murray_radii.h"
#include "core/vessel/root_tree.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

bool hasAllRadii(const VesselTree& tree)
{
    return std::ranges::all_of(tree.branches, [](const VesselBranch& branch) {
        return branch.radiusMm.size() == branch.pointsInPatient.size();
    });
}

/// Returns the thickest end of any branch; the first point if the tree has no radii.
Eigen::Vector3d rootOf(const VesselTree& tree)
{
    Eigen::Vector3d root = tree.branches.front().pointsInPatient.front();
    double thickest = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        if (branch.radiusMm.empty()) {
            continue;
        }
        for (const bool isFront : {true, false}) {
            const double radius = isFront ? branch.radiusMm.front() : branch.radiusMm.back();
            if (radius > thickest) {
                thickest = radius;
                root = isFront ? branch.pointsInPatient.front() : branch.pointsInPatient.back();
            }
        }
    }
    return root;
}

Takeoff nearestTakeoff(const std::vector<VesselBranch>& branches, std::size_t child)
{
    const Eigen::Vector3d& begin = branches[child].pointsInPatient.front();
    Takeoff nearest;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < child; ++b) {
        for (std::size_t i = 0; i < branches[b].pointsInPatient.size(); ++i) {
            const double distance = (branches[b].pointsInPatient[i] - begin).squaredNorm();
            if (distance < best) {
                best = distance;
                nearest = {static_cast<int>(b), i};
            }
        }
    }
    return nearest;
}

}   // namespace

GrownTree withTakeoffs(const VesselTree& tree, double rootRadiusMm)
{
    GrownTree grown;
    grown.tree = rootedAt(tree, rootOf(tree));
    for (std::size_t b = 0; b < grown.tree.branches.size(); ++b) {
        grown.takeoffs.push_back(nearestTakeoff(grown.tree.branches, b));
    }
    if (!hasAllRadii(tree)) {
        assignMurrayRadii(grown, rootRadiusMm);
    }
    return grown;
}

double extentMm(const VesselTree& tree)
{
    Eigen::Vector3d low = tree.branches.front().pointsInPatient.front();
    Eigen::Vector3d high = low;
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    }
    return (high - low).maxCoeff();
}

}   // namespace angiopose::core
