#include "core/tracing/volume/stents/thin_stent.h"

#include "core/support/symmetric.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double minFillOfStent = 0.7;   ///< minimum opacification, as in a large vessel
constexpr double maxFillOfStent = 1.6;
constexpr double minSlendernessOfStent = 1.6;   ///< minimum axial / transverse spread; a tube twice as long as wide
constexpr double maxTransverseMm = 3.5;   ///< maximum transverse spread: a tube of 8 mm with its blur
constexpr double endShare = 0.25;   ///< length of an end section, relative to half the length
constexpr double beyondMm = 2.0;   ///< distance from a tip to the center of the lumen search
constexpr double aroundMm = 3.0;

/// End of a long thin component, and its outward direction.
struct ComponentEnd {
    Eigen::Vector3d tipMm;
    Eigen::Vector3d outwards;
};

/// Returns the end of a component on one side of its center, along its longest axis.
ComponentEnd findEnd(const std::vector<Eigen::Vector3d>& pointsMm, const Eigen::Vector3d& centerMm,
                     const Eigen::Vector3d& towards)
{
    double farthest = 0.0;
    for (const Eigen::Vector3d& point : pointsMm) {
        farthest = std::max(farthest, towards.dot(point - centerMm));
    }
    Eigen::Vector3d outer = Eigen::Vector3d::Zero();
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    double outerCount = 0.0;
    double beforeCount = 0.0;
    for (const Eigen::Vector3d& point : pointsMm) {
        const double along = towards.dot(point - centerMm) / farthest;
        if (along > 1.0 - endShare) {
            outer += point;
            outerCount += 1.0;
        } else if (along > 1.0 - 2.0 * endShare) {
            before += point;
            beforeCount += 1.0;
        }
    }
    outer /= outerCount;
    const Eigen::Vector3d outwards =
        beforeCount > 0.0 ? Eigen::Vector3d(outer - before / beforeCount).normalized() : towards;
    return {outer + (0.5 * endShare * farthest) * outwards, outwards};
}

/// Tube too thin to show lumen inside its struts, with a vessel beyond both ends.
class ThinTube {
public:
    ThinTube(const VoxelComponent& piece, const VolumeGeometry& grid, const VoxelOpacification& opacification)
        : grid_(grid), opacification_(opacification)
    {
        for (const std::uint32_t voxel : piece) {
            pointsMm_.emplace_back(grid.spacingMm.cwiseProduct(grid.voxelAt(voxel).cast<double>()));
            centerMm_ += pointsMm_.back() / static_cast<double>(piece.size());
        }
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const Eigen::Vector3d& point : pointsMm_) {
            spread += (point - centerMm_) * (point - centerMm_).transpose() / static_cast<double>(piece.size());
        }
        const EigenDecomposition<3> axes = eigenDecomposition(spread);
        axis_ = axes.directions.col(2);
        transverseMm_ = std::sqrt(std::max(axes.values[1], 0.0));
        axialMm_ = std::sqrt(std::max(axes.values[2], 0.0));
    }

    bool isContinuedByLumen() const
    {
        return axialMm_ > minSlendernessOfStent * transverseMm_ && transverseMm_ < maxTransverseMm &&
               isLumenBeyond(findEnd(pointsMm_, centerMm_, axis_)) &&
               isLumenBeyond(findEnd(pointsMm_, centerMm_, -axis_));
    }

private:
    /// Returns whether homogeneous opacified lumen lies close beyond the tip; the vessel may curve there.
    bool isLumenBeyond(const ComponentEnd& end) const
    {
        const Eigen::Array3d middle =
            (end.tipMm + beyondMm * end.outwards).cwiseQuotient(grid_.spacingMm).array().round();
        const Eigen::Vector3i reach = (aroundMm / grid_.spacingMm.array()).ceil().cast<int>();
        for (int z = -reach.z(); z <= reach.z(); ++z) {
            for (int y = -reach.y(); y <= reach.y(); ++y) {
                for (int x = -reach.x(); x <= reach.x(); ++x) {
                    const Eigen::Vector3i step(x, y, z);
                    if (grid_.spacingMm.cwiseProduct(step.cast<double>()).norm() <= aroundMm &&
                        isLumenAt(middle.matrix().cast<int>() + step)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /// Returns whether the voxel and its six neighbors have the intensity of the lumen.
    bool isLumenAt(const Eigen::Vector3i& voxel) const
    {
        const auto isLumen = [this](const Eigen::Vector3i& at) {
            const double opacification = grid_.contains(at) ? opacification_(at.x(), at.y(), at.z()) : 0.0;
            return opacification >= minFillOfStent && opacification <= maxFillOfStent;
        };
        bool isHomogeneous = isLumen(voxel);
        for (int axis = 0; axis < 3 && isHomogeneous; ++axis) {
            const Eigen::Vector3i step = Eigen::Vector3i::Unit(axis);
            isHomogeneous = isLumen(voxel - step) && isLumen(voxel + step);
        }
        return isHomogeneous;
    }

    const VolumeGeometry& grid_;
    const VoxelOpacification& opacification_;
    std::vector<Eigen::Vector3d> pointsMm_;
    Eigen::Vector3d centerMm_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
    double transverseMm_ = 0.0;   ///< standard deviation of the points across the axis; `axialMm_` is the one along it
    double axialMm_ = 0.0;
};

}   // namespace

bool isThinStent(const VoxelComponent& piece, const VolumeGeometry& grid, const VoxelOpacification& opacification)
{
    return ThinTube(piece, grid, opacification).isContinuedByLumen();
}

}   // namespace angiopose::core
