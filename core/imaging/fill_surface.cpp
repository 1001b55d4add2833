#include "core/imaging/fill_surface.h"

#include "core/messages/messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double typicalVoxels = 5e7;
constexpr double typicalVoxelsInside = 5e6;
constexpr double minVoxelSpacingMm = 0.1;
constexpr double maxVoxels = 8e8;
constexpr int marginVoxels = 3;
constexpr int rowsPerCancelCheck = 1000;   ///< number of rows of a triangle between checks for cancellation
constexpr std::size_t cancelCheckMask = 0xFFF;   ///< bit mask: triangles between checks for cancellation, minus one

/// Offset of the rays from the voxel centers, in voxels; makes the rays miss vertices and edges of the mesh.
constexpr double rayOffsetB = 1.237e-5;
constexpr double rayOffsetC = 2.713e-5;

struct Box {
    Eigen::Vector3d low, high;
};

Box boxOf(const SurfaceMesh& mesh)
{
    Box box{mesh.pointsInPatient.front(), mesh.pointsInPatient.front()};
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            box.low = box.low.cwiseMin(mesh.pointsInPatient[corner]);
            box.high = box.high.cwiseMax(mesh.pointsInPatient[corner]);
        }
    }
    return box;
}

/// Intersection of a ray with the mesh: position along the ray, and whether the ray enters (+1) or leaves (-1).
struct Crossing {
    double at;
    int turn;
};

enum class Filling { Winding, Parity };

/// Casts rays along one axis through the voxel centers.
class RayCaster {
public:
    RayCaster(const VolumeGeometry& geometry, int axis)
        : size_(geometry.size), a_(axis), b_((axis + 1) % 3), c_((axis + 2) % 3)
    {
        rows_.resize(static_cast<std::size_t>(size_[b_]) * static_cast<std::size_t>(size_[c_]));
    }

    /// Adds the ray intersections of a triangle; can be canceled while processing a large triangle.
    void add(const std::array<Eigen::Vector3d, 3>& corners, const std::function<bool()>& shouldContinue)
    {
        const Eigen::Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Eigen::Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        const Eigen::Vector2d p = flat(corners[0]), q = flat(corners[1]), r = flat(corners[2]);
        const double area = cross(q - p, r - p);
        if (area == 0.0) {
            return;
        }
        const int lastB = std::min(size_[b_] - 1, static_cast<int>(std::floor(high[b_])));
        const int lastC = std::min(size_[c_] - 1, static_cast<int>(std::floor(high[c_])));
        const int firstC = std::max(0, static_cast<int>(std::floor(low[c_])));
        const int firstB = std::max(0, static_cast<int>(std::floor(low[b_])));
        for (int c = firstC; c <= lastC; ++c) {
            if (c > firstC && lastB - firstB > rowsPerCancelCheck && !shouldContinue()) {
                return;
            }
            for (int b = firstB; b <= lastB; ++b) {
                const Eigen::Vector2d ray(b + rayOffsetB, c + rayOffsetC);
                const double u = cross(q - ray, r - ray) / area;
                const double v = cross(r - ray, p - ray) / area;
                const double w = 1.0 - u - v;
                if (u > 0.0 && v > 0.0 && w > 0.0) {
                    const double at = u * corners[0][a_] + v * corners[1][a_] + w * corners[2][a_];
                    rows_[rowIndex(b, c)].push_back({at, area > 0.0 ? 1 : -1});
                }
            }
        }
    }

    /// Adds a vote to every voxel that is inside along this axis; rays that end inside add no vote.
    void vote(Filling filling, VoxelMask& votes, const std::function<bool()>& shouldContinue)
    {
        for (int c = 0; c < size_[c_] && shouldContinue(); ++c) {
            for (int b = 0; b < size_[b_]; ++b) {
                std::vector<Crossing>& row = rows_[rowIndex(b, c)];
                int total = 0;
                for (const Crossing& crossing : row) {
                    total += crossing.turn;
                }
                if (row.empty() || (filling == Filling::Winding ? total != 0 : row.size() % 2 != 0)) {
                    continue;
                }
                std::sort(row.begin(), row.end(), [](const Crossing& x, const Crossing& y) { return x.at < y.at; });
                voteAlong(row, filling, b, c, votes);
            }
        }
    }

private:
    static double cross(const Eigen::Vector2d& x, const Eigen::Vector2d& y) { return x.x() * y.y() - x.y() * y.x(); }
    Eigen::Vector2d flat(const Eigen::Vector3d& point) const { return {point[b_], point[c_]}; }
    std::size_t rowIndex(int b, int c) const
    {
        return static_cast<std::size_t>(c) * static_cast<std::size_t>(size_[b_]) + static_cast<std::size_t>(b);
    }

    void voteAlong(const std::vector<Crossing>& row, Filling filling, int b, int c, VoxelMask& votes) const
    {
        int depth = 0;
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            depth += filling == Filling::Winding ? row[k].turn : (depth == 0 ? 1 : -1);
            if (depth == 0) {
                continue;
            }
            const int first = std::max(0, static_cast<int>(std::ceil(row[k].at)));
            const int last = std::min(size_[a_] - 1, static_cast<int>(std::ceil(row[k + 1].at)) - 1);
            for (int a = first; a <= last; ++a) {
                Eigen::Vector3i voxel;
                voxel[a_] = a;
                voxel[b_] = b;
                voxel[c_] = c;
                ++votes.at(voxel.x(), voxel.y(), voxel.z());
            }
        }
    }

    Eigen::Vector3i size_;
    int a_, b_, c_;
    std::vector<std::vector<Crossing>> rows_;
};

VolumeGeometry gridAround(const Box& box, double spacingMm)
{
    VolumeGeometry geometry;
    geometry.spacingMm = Eigen::Vector3d::Constant(spacingMm);
    geometry.originInPatient = box.low - Eigen::Vector3d::Constant(marginVoxels * spacingMm);
    geometry.size = ((box.high - box.low) / spacingMm).array().ceil().matrix().cast<int>() +
                    Eigen::Vector3i::Constant(2 * marginVoxels + 1);
    return geometry;
}

void castAlong(int axis, const SurfaceMesh& mesh, VoxelMask& votes, Filling filling,
               const std::function<bool()>& shouldContinue)
{
    RayCaster caster(votes.geometry, axis);
    const Eigen::Vector3d origin = votes.geometry.originInPatient;
    const double spacing = votes.geometry.spacingMm.x();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if ((t & cancelCheckMask) == 0 && !shouldContinue()) {
            return;
        }
        const auto& triangle = mesh.triangles[t];
        caster.add({(mesh.pointsInPatient[triangle[0]] - origin) / spacing,
                    (mesh.pointsInPatient[triangle[1]] - origin) / spacing,
                    (mesh.pointsInPatient[triangle[2]] - origin) / spacing},
                   shouldContinue);
    }
    caster.vote(filling, votes, shouldContinue);
}

/// Returns the enclosed volume by the divergence theorem; for an open mesh, the volume of its cones to the box center.
double insideMm3(const SurfaceMesh& mesh, const Box& box)
{
    const Eigen::Vector3d middle = 0.5 * (box.low + box.high);
    double sixVolumes = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const Eigen::Vector3d a = mesh.pointsInPatient[triangle[0]] - middle;
        const Eigen::Vector3d b = mesh.pointsInPatient[triangle[1]] - middle;
        const Eigen::Vector3d c = mesh.pointsInPatient[triangle[2]] - middle;
        sixVolumes += a.dot(b.cross(c));
    }
    return std::abs(sixVolumes) / 6.0;
}

}   // namespace

double defaultSpacingMm(const SurfaceMesh& mesh)
{
    if (mesh.triangles.empty()) {
        return 1.0;
    }
    const Box box = boxOf(mesh);
    const Eigen::Vector3d extent = (box.high - box.low).cwiseMax(0.1);
    // Thinning time depends on the inside voxels: a small part of the box for vessels, all of it for a solid block.
    const double needed = std::max(extent.prod() / typicalVoxels, insideMm3(mesh, box) / typicalVoxelsInside);
    return std::max(std::cbrt(needed), minVoxelSpacingMm);
}

Result<VoxelMask> fillSurface(const SurfaceMesh& mesh, double spacingMm, const std::function<bool()>& shouldContinue)
{
    bool isStopped = false;
    const std::function<bool()> checkContinue = [&] {
        isStopped = isStopped || (shouldContinue && !shouldContinue());
        return !isStopped;
    };
    if (mesh.triangles.empty() || !(spacingMm > 0.0)) {
        return Error(messages::surfaceEmpty());
    }
    const Box box = boxOf(mesh);
    const Eigen::Vector3d extent = box.high - box.low;
    if (!(extent.minCoeff() > 0.0)) {
        return Error(messages::surfaceFlat());
    }
    if (!((extent / spacingMm).prod() < maxVoxels)) {
        return Error(messages::surfaceVoxelTooFine());
    }
    VoxelMask votes(gridAround(box, spacingMm));
    const MeshCheck check = checkMesh(mesh);
    const Filling filling = check.isOriented ? Filling::Winding : Filling::Parity;
    const bool isWatertight = check.isClosed() && check.isOriented;
    for (int axis = 0; axis < (isWatertight ? 1 : 3); ++axis) {
        castAlong(axis, mesh, votes, filling, checkContinue);
    }
    if (isStopped) {
        return Cancellation{messages::tracingStopped()};
    }
    std::size_t inside = 0;
    for (std::uint8_t& voxel : votes.voxels) {
        voxel = voxel >= (isWatertight ? 1 : 2) ? 1 : 0;
        inside += voxel;
    }
    if (inside == 0) {
        return Error(messages::surfaceNothingInside());
    }
    return votes;
}

}   // namespace angiopose::core
