#include "tests/benchmark/label_cover.h"

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/thin_volume.h"
#include "core/tracing/volume/voxels/voxel_components.h"
#include "tests/support/for_each.h"

#include <algorithm>

namespace angiopose::benchmarks {
namespace {

constexpr double reachVoxels = 2.0;
constexpr double twigMm = 4.0;   ///< length beyond the wall of the parent vessel

/// Voxels within reach of the tree's curves.
core::VoxelMask nearTree(const core::VolumeGeometry& grid, const core::VesselTree& tree)
{
    core::VoxelMask near(grid);
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    const double step = 0.4 * grid.spacingMm.minCoeff();
    for (const core::VesselBranch& branch : core::resampled(tree, step).branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const Eigen::Vector3d at = voxelFromPatient * point;
            const Eigen::Vector3i low = (at.array() - reachVoxels).ceil().max(0.0).cast<int>();
            const Eigen::Vector3i high =
                (at.array() + reachVoxels).floor().min(grid.size.cast<double>().array() - 1.0).cast<int>();
            test::forEachVoxel(low, high + Eigen::Vector3i::Ones(), [&](int i, int j, int k) {
                if ((Eigen::Vector3d(i, j, k) - at).norm() <= reachVoxels) {
                    near.at(i, j, k) = 1;
                }
            });
        }
    }
    return near;
}

/// Distance of every voxel from the tree's curves.
core::DistanceMap toTree(const core::VolumeGeometry& grid, const core::VesselTree& tree)
{
    core::VoxelMask others(grid, 1);
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    for (const core::VesselBranch& branch : core::resampled(tree, 0.4 * grid.spacingMm.minCoeff()).branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const Eigen::Vector3i at = (voxelFromPatient * point).array().round().cast<int>();
            if (grid.contains(at)) {
                others.at(at.x(), at.y(), at.z()) = 0;
            }
        }
    }
    core::TracingProgress unheard({});
    return core::distanceMap(others, 1, unheard);
}

/// Share of the vessels' skeleton, without twigs, that is close to the tree.
double coverOfVessels(const core::VoxelMask& mask, const std::vector<std::size_t>& skeleton,
                      const core::DistanceMap& away)
{
    core::TracingProgress unheard({});
    const core::DistanceMap distances = core::distanceMap(mask, 1, unheard);
    const core::VesselGraph graph = core::buildVesselGraph(skeleton, distances, unheard);
    const std::vector<int> degrees = graph.degrees();
    const double minReachMm = reachVoxels * mask.geometry.spacingMm.maxCoeff();
    double all = 0.0;
    double found = 0.0;
    for (const core::VesselEdge& edge : graph.edges) {
        const auto start = static_cast<std::size_t>(edge.startNode);
        const auto end = static_cast<std::size_t>(edge.endNode);
        const bool isTwig = (degrees[start] == 1) != (degrees[end] == 1) &&
                            edge.lengthMm() <= twigMm + graph.nodeRadiusMm[degrees[start] == 1 ? end : start];
        for (std::size_t n = 0; !isTwig && n < edge.pointsMm.size(); ++n) {
            const Eigen::Vector3i at =
                edge.pointsMm[n].cwiseQuotient(mask.geometry.spacingMm).array().round().cast<int>();
            const double reachMm = std::max(minReachMm, 0.5 * edge.radiusMm[n]);
            all += 1.0;
            found += away.mm(mask.geometry.index(at.x(), at.y(), at.z())) <= reachMm ? 1.0 : 0.0;
        }
    }
    return all > 0.0 ? found / all : 1.0;
}

/// Number of connected sets on the six faces.
int cutsOf(const core::VoxelMask& mask)
{
    core::VoxelMask faces(mask.geometry);
    const Eigen::Vector3i& size = mask.geometry.size;
    for (std::size_t v = 0; v < mask.voxels.size(); ++v) {
        const Eigen::Vector3i at = mask.geometry.voxelAt(v);
        const bool isRim = (at.array() == 0).any() || (at.array() == size.array() - 1).any();
        faces.voxels[v] = isRim ? mask.voxels[v] : std::uint8_t{0};
    }
    return static_cast<int>(core::connectedComponents(faces).size());
}

int endsAtRim(const core::VolumeGeometry& grid, const core::VesselTree& tree)
{
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    const auto isAtRim = [&](const Eigen::Vector3d& point) {
        const Eigen::Array3d at = (voxelFromPatient * point).array();
        return (at < 2.0).any() || (at > grid.size.cast<double>().array() - 3.0).any();
    };
    int ends = 0;
    for (const core::VesselBranch& branch : tree.branches) {
        ends += isAtRim(branch.pointsInPatient.back()) ? 1 : 0;
        ends += branch.generation == 0 && isAtRim(branch.pointsInPatient.front()) ? 1 : 0;
    }
    return ends;
}

}   // namespace

LabelCover coverOf(const core::VoxelMask& mask, const core::VesselTree& tree)
{
    core::TracingProgress unheard({});
    const std::vector<std::size_t> skeleton = core::skeletonize(mask, unheard);
    const core::VoxelMask near = nearTree(mask.geometry, tree);
    LabelCover cover;
    std::size_t found = 0;
    for (const std::size_t voxel : skeleton) {
        found += near.voxels[voxel] != 0 ? 1 : 0;
    }
    cover.ofSkeleton = static_cast<double>(found) / static_cast<double>(std::max<std::size_t>(1, skeleton.size()));
    cover.ofVessels = coverOfVessels(mask, skeleton, toTree(mask.geometry, tree));
    core::VoxelMask isSkeleton(mask.geometry);
    for (const std::size_t voxel : skeleton) {
        isSkeleton.voxels[voxel] = 1;
    }
    const std::vector<core::VoxelComponent> pieces = core::connectedComponents(mask);
    double voxels = 0.0;
    for (const core::VoxelComponent& piece : pieces) {
        std::size_t its = 0;
        std::size_t nearOfIts = 0;
        for (const std::uint32_t voxel : piece) {
            its += isSkeleton.voxels[voxel];
            nearOfIts += isSkeleton.voxels[voxel] != 0 && near.voxels[voxel] != 0 ? 1 : 0;
        }
        const bool isTraced = its > 0 && 2 * nearOfIts >= its;
        cover.traced += isTraced ? 1 : 0;
        cover.leftOut += isTraced ? 0.0 : static_cast<double>(piece.size());
        voxels += static_cast<double>(piece.size());
    }
    cover.pieces = pieces.size();
    cover.leftOut /= std::max(1.0, voxels);
    cover.cuts = cutsOf(mask);
    cover.ends = endsAtRim(mask.geometry, tree);
    return cover;
}

}   // namespace angiopose::benchmarks
