#include "core/simulation/simulate_cta.h"

#include "core/simulation/stent_wires.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double airHu = -1000.0;
constexpr double fatHu = -100.0;
constexpr double muscleHu = 45.0;
constexpr double marrowHu = 170.0;
constexpr double trabeculaeHu = 90.0;   ///< standard deviation within the marrow
constexpr double cortexHu = 900.0;
constexpr double tableHu = 150.0;
constexpr double calcificationHu = 950.0;
constexpr double metalHu = 8000.0;   ///< of a stent's wires, before they are blurred
constexpr double treeShare = 0.72;   ///< of the shortest side of the scan

using FloatGrid = VoxelGrid<float>;

/// Share of a voxel that lies inside a wall at `distanceMm` (negative inside).
double coverage(double distanceMm, double voxelMm)
{
    return std::clamp(0.5 - distanceMm / voxelMm, 0.0, 1.0);
}

/// Draws shapes given by their distance function into the part of the grid around them.
class Painter {
public:
    explicit Painter(FloatGrid& grid) : grid_(grid), voxelMm_(std::cbrt(grid.geometry.spacingMm.prod())) {}

    /// `work(voxel index, point)` for each voxel within `reachMm` of `centre` along the axes.
    template <class Work>
    void around(const Eigen::Vector3d& centre, const Eigen::Vector3d& reachMm, const Work& work)
    {
        const VolumeGeometry& geometry = grid_.geometry;
        const Eigen::Array3d middle = (centre - geometry.originInPatient).cwiseQuotient(geometry.spacingMm);
        const Eigen::Array3d reach = reachMm.cwiseQuotient(geometry.spacingMm).array() + 1.0;
        const Eigen::Array3i low = (middle - reach).floor().max(0.0).cast<int>();
        const Eigen::Array3i high = (middle + reach).ceil().min(geometry.size.cast<double>().array() - 1.0).cast<int>();
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                for (int i = low.x(); i <= high.x(); ++i) {
                    work(geometry.index(i, j, k),
                         geometry.originInPatient + geometry.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k)));
                }
            }
        }
    }

    void blend(std::size_t voxel, double share, double hu)
    {
        grid_.voxels[voxel] += static_cast<float>(share * (hu - grid_.voxels[voxel]));
    }

    /// An ellipsoid; an infinite half axis makes a cylinder.
    void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfAxes, double hu)
    {
        ellipsoid(centre, halfAxes, [hu] { return hu; });
    }

    /// The same, of what `draw()` gives for each voxel.
    template <class Draw>
    requires std::is_invocable_r_v<double, Draw>
    void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfAxes, const Draw& draw)
    {
        const double smallest = halfAxes.minCoeff();
        around(centre, halfAxes.cwiseMin(1e5), [&](std::size_t voxel, const Eigen::Vector3d& point) {
            const double radius = (point - centre).cwiseQuotient(halfAxes).norm();
            if (const double share = coverage((radius - 1.0) * smallest, voxelMm_); share > 0.0) {
                blend(voxel, share, draw());
            }
        });
    }

    double voxelMm() const { return voxelMm_; }

private:
    FloatGrid& grid_;
    double voxelMm_;
};

/// Extent of the scan in the patient.
struct Field {
    Eigen::Vector3d centre;
    Eigen::Vector3d half;
};

Field fieldOf(const VolumeGeometry& geometry)
{
    const Eigen::Vector3d half = 0.5 * geometry.spacingMm.cwiseProduct(geometry.size.cast<double>());
    return {geometry.originInPatient + half - 0.5 * geometry.spacingMm, half};
}

void paintBody(Painter& painter, const Field& field)
{
    const double endless = std::numeric_limits<double>::infinity();
    painter.ellipsoid(field.centre, {0.97 * field.half.x(), 0.93 * field.half.y(), endless}, fatHu);
    painter.ellipsoid(field.centre, {0.9 * field.half.x(), 0.86 * field.half.y(), endless}, muscleHu);
}

/// Liver, spleen and kidneys with some contrast, lungs at the top.
void paintOrgans(Painter& painter, const Field& field, CounterRandom& random)
{
    const auto place = [&](double x, double y, double z) {
        return (field.centre + field.half.cwiseProduct(Eigen::Vector3d(x, y, z)) +
                3.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()))
            .eval();
    };
    painter.ellipsoid(place(-0.4, -0.1, 0.2), field.half.cwiseProduct(Eigen::Vector3d(0.4, 0.5, 0.5)), 105.0);
    painter.ellipsoid(place(0.55, 0.2, 0.3), field.half.cwiseProduct(Eigen::Vector3d(0.2, 0.3, 0.35)), 120.0);
    for (const double side : {-1.0, 1.0}) {
        painter.ellipsoid(place(0.5 * side, 0.35, -0.4), field.half.cwiseProduct(Eigen::Vector3d(0.15, 0.18, 0.3)),
                          150.0);
        painter.ellipsoid(place(0.5 * side, 0.0, 1.05), field.half.cwiseProduct(Eigen::Vector3d(0.3, 0.5, 0.3)),
                          -850.0);
    }
}

/// Spine and ribs: shells of cortex around uneven marrow.
void paintSkeleton(Painter& painter, const Field& field, CounterRandom& random)
{
    const auto marrow = [&] { return marrowHu + trabeculaeHu * random.normal(); };
    const double depth = 0.72 * field.half.y();
    constexpr double vertebraMm = 30.0;
    for (double z = -field.half.z(); z < field.half.z() + vertebraMm; z += vertebraMm) {
        const Eigen::Vector3d vertebra = field.centre + Eigen::Vector3d(0.0, depth, z);
        painter.ellipsoid(vertebra, {17.0, 14.0, 16.0}, cortexHu);
        painter.ellipsoid(vertebra, {15.4, 12.4, 14.4}, marrow);
        for (const double side : {-1.0, 1.0}) {
            const auto bead = [&](int number) {
                const double angle = side * (0.5 + 0.03 * number);
                return (field.centre + Eigen::Vector3d(0.88 * field.half.x() * std::sin(angle),
                                                       0.8 * field.half.y() * std::cos(angle), z - 0.4 * number))
                    .eval();
            };
            for (int number = 0; number < 60; ++number) {
                painter.ellipsoid(bead(number), Eigen::Vector3d::Constant(4.5), cortexHu);
            }
            for (int number = 0; number < 60; ++number) {
                painter.ellipsoid(bead(number), Eigen::Vector3d::Constant(3.2), marrow);
            }
        }
    }
}

void paintTable(Painter& painter, const Field& field)
{
    const double top = field.centre.y() + 0.95 * field.half.y();
    painter.around({field.centre.x(), top + 2.0, field.centre.z()}, {field.half.x(), 3.0, field.half.z()},
                   [&](std::size_t voxel, const Eigen::Vector3d& point) {
                       painter.blend(voxel, coverage(std::abs(point.y() - top - 2.0) - 1.5, painter.voxelMm()),
                                     tableHu);
                   });
}

/// Share of each voxel that is lumen.
FloatGrid lumenShares(const VesselTree& tree, const VolumeGeometry& geometry)
{
    FloatGrid shares(geometry, 0.0F);
    Painter painter(shares);
    const double stepMm = 0.3 * painter.voxelMm();
    for (const VesselBranch& branch : resampled(tree, stepMm).branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3d& centre = branch.pointsInPatient[n];
            const double radius = branch.radiusMm[n];
            painter.around(centre, Eigen::Vector3d::Constant(radius + painter.voxelMm()),
                           [&](std::size_t voxel, const Eigen::Vector3d& point) {
                               const double share = coverage((point - centre).norm() - radius, painter.voxelMm());
                               shares.voxels[voxel] = std::max(shares.voxels[voxel], static_cast<float>(share));
                           });
        }
    }
    return shares;
}

void paintTree(Painter& painter, const VesselTree& tree, const VolumeGeometry& geometry, double hu)
{
    const FloatGrid shares = lumenShares(tree, geometry);
    for (std::size_t voxel = 0; voxel < shares.voxels.size(); ++voxel) {
        painter.blend(voxel, shares.voxels[voxel], hu);
    }
}

/// Chalk in the wall, hardly reaching into the lumen.
void paintCalcifications(Painter& painter, const VesselTree& tree, int count, CounterRandom& random)
{
    for (int n = 0; n < count; ++n) {
        const VesselBranch& branch =
            tree.branches[static_cast<std::size_t>(random.index(static_cast<int>(tree.branches.size())))];
        const auto at = static_cast<std::size_t>(random.index(static_cast<int>(branch.pointsInPatient.size())));
        const Eigen::Vector3d aside = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
        const double size = random.uniform(0.5, 1.4);
        painter.ellipsoid(branch.pointsInPatient[at] + (branch.radiusMm[at] + 0.6 * size) * aside,
                          Eigen::Vector3d::Constant(size), calcificationHu);
    }
}

/// Gaussian blur along each axis in turn, the rim's values going on.
void blur(FloatGrid& grid, double sigmaVoxels)
{
    const int reach = static_cast<int>(std::ceil(3.0 * sigmaVoxels));
    std::vector<float> kernel;
    kernel.reserve(2 * static_cast<std::size_t>(reach) + 1);
    float sum = 0.0F;
    for (int n = -reach; n <= reach; ++n) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigmaVoxels * sigmaVoxels))));
        sum += kernel.back();
    }
    const Eigen::Vector3i& size = grid.geometry.size;
    const std::ptrdiff_t strides[3] = {1, size.x(), static_cast<std::ptrdiff_t>(size.x()) * size.y()};
    for (int axis = 0; axis < 3; ++axis) {
        const int count = size[axis];
        std::vector<float> line(static_cast<std::size_t>(count));
        const Eigen::Vector3i ends = axis == 0   ? Eigen::Vector3i(1, size.y(), size.z())
                                     : axis == 1 ? Eigen::Vector3i(size.x(), 1, size.z())
                                                 : Eigen::Vector3i(size.x(), size.y(), 1);
        for (int k = 0; k < ends.z(); ++k) {
            for (int j = 0; j < ends.y(); ++j) {
                for (int i = 0; i < ends.x(); ++i) {
                    float* first = &grid.at(i, j, k);
                    for (int n = 0; n < count; ++n) {
                        line[static_cast<std::size_t>(n)] = first[n * strides[axis]];
                    }
                    for (int n = 0; n < count; ++n) {
                        float value = 0.0F;
                        for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
                            const int at = std::clamp(n + static_cast<int>(tap) - reach, 0, count - 1);
                            value += kernel[tap] * line[static_cast<std::size_t>(at)];
                        }
                        first[n * strides[axis]] = value / sum;
                    }
                }
            }
        }
    }
}

Volume asStored(const FloatGrid& grid, double noiseHu, const CounterRandom& random)
{
    Volume volume(grid.geometry);
    const auto sliceVoxels =
        static_cast<std::size_t>(grid.geometry.size.x()) * static_cast<std::size_t>(grid.geometry.size.y());
    for (int k = 0; k < grid.geometry.size.z(); ++k) {
        CounterRandom ofSlice = random.fork(static_cast<std::uint64_t>(k));
        for (std::size_t n = 0; n < sliceVoxels; ++n) {
            const std::size_t voxel = static_cast<std::size_t>(k) * sliceVoxels + n;
            const double value = grid.voxels[voxel] + noiseHu * ofSlice.normal();
            volume.voxels[voxel] = static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, 3071.0)));
        }
    }
    return volume;
}

}   // namespace

SimulatedCta simulateCta(std::uint64_t seed, const TreeOptions& tree, const CtaOptions& cta)
{
    CounterRandom random(seed ^ 0xC7A0ULL);
    VolumeGeometry geometry;
    geometry.size = cta.size;
    geometry.spacingMm = cta.spacingMm;
    geometry.originInPatient = -0.5 * cta.spacingMm.cwiseProduct((cta.size.array() - 1).cast<double>().matrix());
    const Field field = fieldOf(geometry);

    TreeOptions fitting = tree;
    fitting.extentMm = std::min(tree.extentMm, 2.0 * treeShare * field.half.minCoeff());
    SimulatedCta result;
    result.tree = simulateTree(seed, fitting);

    FloatGrid grid(geometry, static_cast<float>(airHu));
    Painter painter(grid);
    paintBody(painter, field);
    paintOrgans(painter, field, random);
    paintSkeleton(painter, field, random);
    paintTable(painter, field);
    paintTree(painter, result.tree, geometry, cta.bloodHu);
    if (cta.hasStent) {
        paintTree(painter, stentWires(result.tree.branches.front()), geometry, metalHu);
    }
    paintCalcifications(painter, result.tree, cta.calcificationCount, random);
    blur(grid, cta.blurVoxels);
    result.volume = asStored(grid, cta.noiseHu, random.fork(1));
    return result;
}

}   // namespace angiopose::core