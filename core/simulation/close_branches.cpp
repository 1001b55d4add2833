#include "core/simulation/close_branches.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr double thinRadiusMm = 1.2;   ///< branches below are missing twice as often

bool hasFilledChild(const GrownTree& grown, const std::vector<bool>& filled, std::size_t branch)
{
    for (std::size_t child = branch + 1; child < filled.size(); ++child) {
        if (filled[child] && grown.takeoffs[child].parentIndex == static_cast<int>(branch)) {
            return true;
        }
    }
    return false;
}

/// A filled branch without filled children; 0, the trunk, when there is none.
std::size_t drawEndBranch(const GrownTree& grown, const std::vector<bool>& filled, CounterRandom& random)
{
    std::vector<std::size_t> tickets;
    for (std::size_t b = 1; b < filled.size(); ++b) {
        if (filled[b] && !hasFilledChild(grown, filled, b)) {
            const bool isThin = grown.tree.branches[b].radiusMm.front() < thinRadiusMm;
            tickets.insert(tickets.end(), isThin ? 2 : 1, b);
        }
    }
    return tickets.empty() ? 0 : tickets[static_cast<std::size_t>(random.index(static_cast<int>(tickets.size())))];
}

}   // namespace

std::vector<bool> drawFilledBranches(const GrownTree& grown, double missingShare, CounterRandom& random)
{
    std::vector<bool> filled(grown.tree.branches.size(), true);
    const auto missing = static_cast<int>(std::lround(missingShare * static_cast<double>(filled.size())));
    for (int i = 0; i < missing; ++i) {
        const std::size_t branch = drawEndBranch(grown, filled, random);
        if (branch != 0) {
            filled[branch] = false;
        }
    }
    return filled;
}

}   // namespace angiopose::core