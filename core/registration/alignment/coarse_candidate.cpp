#include "core/registration/alignment/coarse_candidate.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t keptCandidates = 12;
constexpr double minScoreShare = 0.8;   // minimum score of a kept candidate, as a fraction of the best score

bool isSame(const CentroidPose& a, const CentroidPose& b, const Basin& basin)
{
    return (a.centroidInCamera - b.centroidInCamera).norm() < basin.shiftMm &&
           angleBetween(a.rotation, b.rotation) < basin.turn;
}

}   // namespace

std::vector<CoarseCandidate> distinctCandidates(std::vector<CoarseCandidate> candidates, const Basin& basin)
{
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const CoarseCandidate& a, const CoarseCandidate& b) { return a.score > b.score; });
    std::vector<CoarseCandidate> best;
    for (const CoarseCandidate& candidate : candidates) {
        if (best.size() == keptCandidates || candidate.score < minScoreShare * candidates.front().score) {
            break;
        }
        if (std::none_of(best.begin(), best.end(),
                         [&](const CoarseCandidate& other) { return isSame(candidate.pose, other.pose, basin); })) {
            best.push_back(candidate);
        }
    }
    return best;
}

}   // namespace angiopose::core
