#include "core/simulation/prune_tree.h"

#include <map>

namespace angiopose::core {

std::vector<int> leafBranchIds(const VesselTree& tree)
{
    struct Ends {
        int bifurcations = 0;
        int tips = 0;
    };
    std::map<int, Ends> endsOfBranch;
    for (const VesselNode& node : findNodes(tree)) {
        for (const int id : node.branchIds) {
            (node.isBifurcation() ? endsOfBranch[id].bifurcations : endsOfBranch[id].tips) += 1;
        }
    }
    std::vector<int> leaves;
    for (const VesselBranch& branch : tree.branches) {
        const Ends& ends = endsOfBranch[branch.id];
        if (ends.bifurcations == 1 && ends.tips == 1) {
            leaves.push_back(branch.id);
        }
    }
    return leaves;
}

VesselTree removeRandomLeaves(const VesselTree& tree, int count, CounterRandom& random)
{
    std::vector<int> leaves = leafBranchIds(tree);
    std::vector<int> removed;
    while (static_cast<int>(removed.size()) < count && !leaves.empty()) {
        const auto chosen = leaves.begin() + random.index(static_cast<int>(leaves.size()));
        removed.push_back(*chosen);
        leaves.erase(chosen);
    }
    return withoutBranches(tree, removed);
}

}   // namespace angiopose::core
