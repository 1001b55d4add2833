#include "core/vessel/root_tree.h"

#include "core/vessel/edit_tree.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr std::size_t radiusPoints = 5;   ///< number of points over which the radius of an end is averaged

double endRadius(const VesselBranch& branch, bool isLastPoint)
{
    if (branch.radiusMm.empty()) {
        return 0.0;
    }
    const std::size_t count = std::min(radiusPoints, branch.radiusMm.size());
    const auto first =
        isLastPoint ? branch.radiusMm.end() - static_cast<std::ptrdiff_t>(count) : branch.radiusMm.begin();
    return std::accumulate(first, first + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
}

void reverseBranch(VesselBranch& branch)
{
    std::reverse(branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    std::reverse(branch.radiusMm.begin(), branch.radiusMm.end());
}

/// Returns the index of the branch point nearest to a position, or the number of points if none touches it.
std::size_t touchingPoint(const VesselBranch& branch, const Eigen::Vector3d& point)
{
    std::size_t best = branch.pointsInPatient.size();
    double nearest = maxContactMm;
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const double distance = (branch.pointsInPatient[i] - point).norm();
        if (distance <= nearest) {
            nearest = distance;
            best = i;
        }
    }
    return best;
}

/// Traverses the vessels from a root and collects the branches in this order.
class RootedTreeBuilder {
public:
    explicit RootedTreeBuilder(const VesselTree& tree) : remaining_(tree.branches.begin(), tree.branches.end())
    {
        for (const VesselBranch& branch : tree.branches) {
            nextId_ = std::max(nextId_, branch.id + 1);
        }
    }

    bool isDone() const { return remaining_.empty(); }

    /// Traverses the vessels from the branch end with the highest score, `worth(branch, isLastPoint)`.
    template <class Score>
    void addFromBestEnd(const Score& score)
    {
        std::size_t best = 0;
        bool bestAtBack = false;
        double bestScore = -std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < remaining_.size(); ++b) {
            for (const bool isLastPoint : {false, true}) {
                if (const double value = score(remaining_[b], isLastPoint); value > bestScore) {
                    bestScore = value;
                    best = b;
                    bestAtBack = isLastPoint;
                }
            }
        }
        VesselBranch root = extract(best);
        if (bestAtBack) {
            reverseBranch(root);
        }
        root.generation = 0;
        const std::size_t first = result_.branches.size();
        result_.branches.push_back(std::move(root));
        for (std::size_t b = first; b < result_.branches.size(); ++b) {
            addChildren(b);
        }
    }

    VesselTree result() { return std::move(result_); }

private:
    VesselBranch extract(std::size_t index)
    {
        VesselBranch branch = std::move(remaining_[index]);
        remaining_.erase(remaining_.begin() + static_cast<std::ptrdiff_t>(index));
        return branch;
    }

    void addChildren(std::size_t parentIndex)
    {
        for (std::size_t b = 0; b < remaining_.size();) {
            const VesselBranch& parent = result_.branches[parentIndex];
            const int generation = parent.generation + 1;
            const Eigen::Vector3d end = parent.pointsInPatient.back();
            const bool startsHere =
                touchingPoint(parent, remaining_[b].pointsInPatient.front()) < parent.pointsInPatient.size();
            const bool endsHere =
                touchingPoint(parent, remaining_[b].pointsInPatient.back()) < parent.pointsInPatient.size();
            const std::size_t at = touchingPoint(remaining_[b], end);
            const bool isEntered = at < remaining_[b].pointsInPatient.size();
            if (!startsHere && !endsHere && !isEntered) {
                ++b;
                continue;
            }
            VesselBranch child = extract(b);
            if (!startsHere && endsHere) {
                reverseBranch(child);
            } else if (!startsHere && at + 1 < child.pointsInPatient.size() && at > 0) {
                addChild(secondPart(child, at), generation);
                reverseBranch(child);
            }
            addChild(std::move(child), generation);
        }
    }

    void addChild(VesselBranch child, int generation)
    {
        child.generation = generation;
        result_.branches.push_back(std::move(child));
    }

    /// Splits off the part after point `at`, which then belongs to both parts.
    VesselBranch secondPart(VesselBranch& branch, std::size_t at)
    {
        const auto from = static_cast<std::ptrdiff_t>(at);
        VesselBranch second{
            nextId_++, "", {branch.pointsInPatient.begin() + from, branch.pointsInPatient.end()}, {}, -1};
        branch.pointsInPatient.resize(at + 1);
        if (!branch.radiusMm.empty()) {
            second.radiusMm.assign(branch.radiusMm.begin() + from, branch.radiusMm.end());
            branch.radiusMm.resize(at + 1);
        }
        return second;
    }

    std::deque<VesselBranch> remaining_;
    VesselTree result_;
    int nextId_ = 1;
};

}   // namespace

VesselTree rootTreeAt(const VesselTree& tree, const Eigen::Vector3d& rootInPatient)
{
    RootedTreeBuilder builder(tree);
    if (!builder.isDone()) {
        builder.addFromBestEnd([&](const VesselBranch& branch, bool isLastPoint) {
            const auto& points = branch.pointsInPatient;
            return -((isLastPoint ? points.back() : points.front()) - rootInPatient).norm();
        });
    }
    while (!builder.isDone()) {
        builder.addFromBestEnd(
            [](const VesselBranch& branch, bool isLastPoint) { return endRadius(branch, isLastPoint); });
    }
    return builder.result();
}

}   // namespace angiopose::core
