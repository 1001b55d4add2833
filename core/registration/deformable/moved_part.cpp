#include "core/registration/deformable/moved_part.h"

#include "core/registration/deformable/motion_of_tree.h"
#include "core/support/quantile.h"
#include "core/vessel/polyline.h"

#include <array>

namespace angiopose::core {
namespace {

constexpr std::array<double, 7> cutsTried{0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
constexpr double maxLeftOver = 0.35;   // fraction of the squared motion left unexplained by two rigid parts
constexpr double minPartShiftMm = 2.0;
constexpr double samplesMm = 5.0;

/// Evenly spaced positions before and after the motion.
struct MovedSamples {
    std::vector<Eigen::Vector3d> before;
    std::vector<Eigen::Vector3d> after;

    void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
        before.push_back(from);
        after.push_back(to);
    }
    RigidTransform rigid() const { return nearestRigid(before, after, std::vector<double>(before.size(), 1.0)); }
    double leftOver(const RigidTransform& rigidly) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            sum += (rigidly * before[k] - after[k]).squaredNorm();
        }
        return sum;
    }
};

MovedSamples movedSamplesOf(const VesselTree& tree, const DeformableResult& result)
{
    MovedSamples samples;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        const auto stations = evenStations<3>(points, samplesMm);
        const auto places = interpolate(points, stations);
        const auto motions = interpolate(result.branches[b].displacementMm, stations);
        for (std::size_t k = 0; k < places.size(); ++k) {
            samples.add(places[k], places[k] + motions[k]);
        }
    }
    return samples;
}

}   // namespace

std::optional<MovedPart> movedPart(const VesselTree& tree, const DeformableResult& result)
{
    const MovedSamples all = movedSamplesOf(tree, result);
    double least = maxLeftOver * all.leftOver(all.rigid());
    std::optional<MovedPart> found;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> heights;
        for (const Eigen::Vector3d& place : all.before) {
            heights.push_back(place[axis]);
        }
        for (const double cut : cutsTried) {
            const double height = quantile(heights, cut);
            MovedSamples low;
            MovedSamples high;
            for (std::size_t k = 0; k < all.before.size(); ++k) {
                (heights[k] < height ? low : high).add(all.before[k], all.after[k]);
            }
            if (low.before.empty() || high.before.empty()) {
                continue;
            }
            const double left = low.leftOver(low.rigid()) + high.leftOver(high.rigid());
            if (left >= least) {
                continue;
            }
            least = left;
            const bool isHighSmaller = high.before.size() <= low.before.size();
            const MovedSamples& part = isHighSmaller ? high : low;
            const RigidTransform restRigid = (isHighSmaller ? low : high).rigid();
            MovedPart moved;
            moved.side = (isHighSmaller ? 1.0 : -1.0) * Eigen::Vector3d::Unit(axis);
            moved.share = static_cast<double>(part.before.size()) / static_cast<double>(all.before.size());
            moved.shift.setZero();
            for (std::size_t k = 0; k < part.before.size(); ++k) {
                moved.shift += (part.after[k] - restRigid * part.before[k]) / static_cast<double>(part.before.size());
            }
            found = moved;
        }
    }
    return found && found->shift.norm() >= minPartShiftMm ? found : std::nullopt;
}

}   // namespace angiopose::core
