#include "tests/benchmark/thoracic_course.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::benchmarks {
namespace {

constexpr double sampleMm = 0.5;
constexpr double axisReachMm = 2.0;   ///< search radius along an axis
constexpr double arterialTolerance = 0.1;   ///< relative tolerance on the value of the masked arteries

using core::medianOf;

OutsideRun runOf(const core::VesselBranch& branch, std::size_t first, std::size_t last, OutsideKind kind,
                 const ThoracicScan& thorax)
{
    std::vector<double> values;
    double farthestMm = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        values.push_back(thorax.value(branch.pointsInPatient[i]));
        farthestMm = std::max(farthestMm, thorax.mmToArteries(branch.pointsInPatient[i]));
    }
    const auto radii = branch.radiusMm.begin();
    return {branch.id,
            sampleMm * static_cast<double>(last - first),
            medianOf({radii + static_cast<std::ptrdiff_t>(first), radii + static_cast<std::ptrdiff_t>(last)}),
            medianOf(values),
            branch.pointsInPatient[first],
            branch.pointsInPatient[last - 1],
            farthestMm,
            false,
            kind};
}

/// Follows the curves from the root and determines for each point how it lies outside the masks; nothing if it lies
/// inside.
class OutsideKinds {
public:
    explicit OutsideKinds(const ThoracicScan& thorax) : thorax_(thorax) {}

    using Kinds = std::vector<std::optional<OutsideKind>>;

    /// Kinds of the branch's points. Parents must be processed before their children.
    Kinds of(const core::VesselBranch& branch)
    {
        const auto& way = branch.pointsInPatient;
        Kinds kinds;
        for (const Eigen::Vector3d& point : way) {
            const std::optional<OutsideKind> before = kinds.empty() ? kindBefore(way) : kinds.back();
            const Eigen::Vector3d& left = kinds.empty() ? point : way[kinds.size() - 1];
            kinds.push_back(kindAt(point, before, left));
        }
        points_.insert(points_.end(), way.begin(), way.end());
        kinds_.insert(kinds_.end(), kinds.begin(), kinds.end());
        return kinds;
    }

private:
    std::optional<OutsideKind> kindAt(const Eigen::Vector3d& point, std::optional<OutsideKind> before,
                                      const Eigen::Vector3d& left) const
    {
        if (thorax_.isArtery(point)) {
            return std::nullopt;
        }
        if (thorax_.isLumen(point)) {
            return OutsideKind::BothLumens;
        }
        if (before && *before != OutsideKind::BothLumens) {
            return before;
        }
        return thorax_.isAtAnEnd(left) ? OutsideKind::BeyondAnEnd : OutsideKind::Elsewhere;
    }

    /// Kind of the point where a branch originates; the first branch may enter through an end.
    std::optional<OutsideKind> kindBefore(const std::vector<Eigen::Vector3d>& way) const
    {
        if (points_.empty()) {
            const auto in =
                std::find_if(way.begin(), way.end(), [this](const auto& point) { return thorax_.isLumen(point); });
            return in != way.end() && thorax_.isAtAnEnd(*in) ? OutsideKind::BeyondAnEnd : OutsideKind::Elsewhere;
        }
        const auto nearest = std::min_element(points_.begin(), points_.end(), [&](const auto& a, const auto& b) {
            return (a - way.front()).squaredNorm() < (b - way.front()).squaredNorm();
        });
        return kinds_[static_cast<std::size_t>(nearest - points_.begin())];
    }

    const ThoracicScan& thorax_;
    std::vector<Eigen::Vector3d> points_;
    Kinds kinds_;
};

/// Share of the axis along which a curve runs. The axis of an aorta with two lumens lies between them, where a distance
/// to it would be meaningless.
double coveredShare(const std::vector<Eigen::Vector3d>& axis, const std::vector<Eigen::Vector3d>& insidePoints)
{
    std::vector<bool> isBeside(axis.size(), false);
    for (const Eigen::Vector3d& point : insidePoints) {
        const auto nearest = std::min_element(axis.begin(), axis.end(), [&](const auto& a, const auto& b) {
            return (a - point).squaredNorm() < (b - point).squaredNorm();
        });
        isBeside[static_cast<std::size_t>(nearest - axis.begin())] = true;
    }
    std::size_t covered = 0;
    for (const Eigen::Vector3d& point : axis) {
        for (std::size_t n = 0; n < axis.size(); ++n) {
            if (isBeside[n] && (axis[n] - point).norm() <= axisReachMm) {
                ++covered;
                break;
            }
        }
    }
    return static_cast<double>(covered) / std::max(1.0, static_cast<double>(axis.size()));
}

bool isSeen(const core::VolumeGeometry& geometry, const Eigen::Vector3d& inPatient)
{
    const Eigen::Vector3d voxel = geometry.patientFromVoxel().inverse() * inPatient;
    return geometry.contains(voxel.array().round().cast<int>().matrix());
}

std::vector<Eigen::Vector3d> axisWithin(const core::VesselTree& axes, const core::VolumeGeometry* seen)
{
    std::vector<Eigen::Vector3d> axis;
    for (const core::VesselBranch& branch : core::resampled(axes, sampleMm).branches) {
        std::copy_if(branch.pointsInPatient.begin(), branch.pointsInPatient.end(), std::back_inserter(axis),
                     [&](const Eigen::Vector3d& point) { return seen == nullptr || isSeen(*seen, point); });
    }
    return axis;
}

}   // namespace

Course courseOf(const core::VesselTree& tree, const ThoracicScan& thorax, const core::VolumeGeometry* seen)
{
    Course course;
    std::vector<Eigen::Vector3d> insidePoints;
    std::vector<double> insideValues;
    OutsideKinds outsideKinds(thorax);
    for (const core::VesselBranch& branch : core::resampled(tree, sampleMm).branches) {
        const auto& way = branch.pointsInPatient;
        const OutsideKinds::Kinds kinds = outsideKinds.of(branch);
        for (std::size_t i = 0; i < way.size();) {
            const std::size_t first = i;
            while (i < way.size() && kinds[i] == kinds[first]) {
                ++i;
            }
            if (kinds[first]) {
                course.outside.push_back(runOf(branch, first, i, *kinds[first], thorax));
                continue;
            }
            for (std::size_t n = first; n < i; ++n) {
                insidePoints.push_back(way[n]);
                insideValues.push_back(thorax.value(way[n]));
            }
        }
    }
    const double arteryValue = medianOf(insideValues);
    const double insideMm = sampleMm * static_cast<double>(insidePoints.size());
    double arterialMm = 0.0;
    double otherMm = 0.0;
    double lumensMm = 0.0;
    double beyondMm = 0.0;
    for (OutsideRun& run : course.outside) {
        run.isArterial = std::abs(run.value - arteryValue) <= arterialTolerance * arteryValue;
        (run.isArterial ? arterialMm : otherMm) += run.lengthMm;
        lumensMm += run.kind == OutsideKind::BothLumens ? run.lengthMm : 0.0;
        beyondMm += run.kind == OutsideKind::BeyondAnEnd ? run.lengthMm : 0.0;
    }
    course.lengthMm = insideMm + arterialMm + otherMm;
    const double all = std::max(course.lengthMm, sampleMm);
    course.inside = insideMm / all;
    course.insideOfJudged = (insideMm + lumensMm) / std::max(course.lengthMm - beyondMm, sampleMm);
    course.outsideArterial = arterialMm / all;
    course.outsideOther = otherMm / all;
    course.covered = coveredShare(axisWithin(thorax.axes, seen), insidePoints);
    return course;
}

}   // namespace angiopose::benchmarks
