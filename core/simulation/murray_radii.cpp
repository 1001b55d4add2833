#include "core/simulation/murray_radii.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double shareFedAtTip = 0.35;   ///< fraction of a branch's own flow; the rest leaves evenly along its length
constexpr double transitionMm = 4.0;   ///< half the length over which the lumen narrows at a bifurcation

/// Returns the moving average over ±`reach` points, over fewer near the ends.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t reach)
{
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t within = std::min({reach, i, values.size() - 1 - i});
        double sum = 0.0;
        for (std::size_t k = i - within; k <= i + within; ++k) {
            sum += values[k];
        }
        result[i] = sum / static_cast<double>(2 * within + 1);
    }
    return result;
}

}   // namespace

void assignMurrayRadii(GrownTree& grown, double rootRadiusMm)
{
    std::vector<VesselBranch>& branches = grown.tree.branches;
    std::vector<std::vector<double>> flow(branches.size());
    for (std::size_t b = branches.size(); b-- > 0;) {
        const std::size_t count = branches[b].pointsInPatient.size();
        const double own = branches[b].lengthMm();
        flow[b].resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double remaining = 1.0 - static_cast<double>(i) / static_cast<double>(count - 1);
            flow[b][i] = own * (shareFedAtTip + (1.0 - shareFedAtTip) * remaining);
        }
        // Children come after their parent in the list and are processed first; their flow is complete.
        for (std::size_t child = b + 1; child < branches.size(); ++child) {
            if (grown.takeoffs[child].parentIndex == static_cast<int>(b)) {
                for (std::size_t i = 0; i <= grown.takeoffs[child].parentPoint; ++i) {
                    flow[b][i] += flow[child].front();
                }
            }
        }
    }
    const double inlet = flow.front().front();
    for (std::size_t b = 0; b < branches.size(); ++b) {
        std::vector<double> radii;
        for (const double q : flow[b]) {
            radii.push_back(rootRadiusMm * std::cbrt(q / inlet));
        }
        const double spacingMm = branches[b].lengthMm() / static_cast<double>(radii.size() - 1);
        branches[b].radiusMm = smoothed(radii, static_cast<std::size_t>(transitionMm / spacingMm));
    }
}

}   // namespace angiopose::core
