#include "core/tracing/volume/lumen/mark_tubes.h"

#include "core/support/parallel_for.h"
#include "core/support/wide_vectors.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr int blockSize = 64;
constexpr std::array<double, 3> scalesInVoxels{0.9, 1.7, 3.0};
constexpr double reachInSigmas = 3.0;
constexpr float minCurvature = 0.075F;   ///< minimum curvature × σ² / lumen contrast; a vessel of radius σ has 0.3
constexpr float minRoundness = 0.33F;   ///< minimum ratio of the transverse curvatures; a sheet has 0
constexpr float maxAxialRatio = 0.75F;   ///< maximum axial / weaker transverse curvature; a sphere has 1

/// Opacification in a block of the scan with a margin.
struct TubeBlock {
    Eigen::Vector3i low;   ///< first voxel in the volume, margin included; may lie outside
    Eigen::Vector3i size;
    std::vector<float> fill;

    std::ptrdiff_t index(int i, int j, int k) const
    {
        return (static_cast<std::ptrdiff_t>(k) * size.y() + j) * size.x() + i;
    }
};

ANGIOPOSE_WIDE_VECTORS
void addRow(const float* from, float weight, float* to, std::ptrdiff_t count)
{
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        to[i] += weight * from[i];
    }
}

std::vector<float> gaussian(double sigma)
{
    const int reach = static_cast<int>(std::ceil(reachInSigmas * sigma));
    std::vector<float> kernel;
    float sum = 0.0F;
    for (int n = -reach; n <= reach; ++n) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigma * sigma))));
        sum += kernel.back();
    }
    for (float& weight : kernel) {
        weight /= sum;
    }
    return kernel;
}

/// Smooths along one axis; values at the border of the block are repeated.
void smoothAlong(TubeBlock& block, std::vector<float>& scratch, int axis, double sigma)
{
    const std::vector<float> kernel = gaussian(sigma);
    const int reach = static_cast<int>(kernel.size() / 2);
    const std::ptrdiff_t stride = axis == 0 ? 1 : axis == 1 ? block.size.x() : block.size.x() * block.size.y();
    const int count = block.size[axis];
    // Number of contiguous values smoothed together: rows for the second axis, slices for the third.
    const std::ptrdiff_t run = axis == 0 ? 1 : stride;
    const auto total = static_cast<std::ptrdiff_t>(block.fill.size());
    std::fill(scratch.begin(), scratch.end(), 0.0F);
    if (axis == 0) {
        std::vector<float> line(static_cast<std::size_t>(count + 2 * reach));
        for (std::ptrdiff_t row = 0; row < total; row += count) {
            for (int n = 0; n < count + 2 * reach; ++n) {
                line[static_cast<std::size_t>(n)] =
                    block.fill[static_cast<std::size_t>(row + std::clamp(n - reach, 0, count - 1))];
            }
            for (std::size_t n = 0; n < kernel.size(); ++n) {
                addRow(&line[n], kernel[n], &scratch[static_cast<std::size_t>(row)], count);
            }
        }
    } else {
        for (std::ptrdiff_t base = 0; base < total; base += run * count) {
            for (int n = 0; n < count; ++n) {
                for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
                    const int neighbor = std::clamp(n + static_cast<int>(tap) - reach, 0, count - 1);
                    addRow(&block.fill[static_cast<std::size_t>(base + run * neighbor)], kernel[tap],
                           &scratch[static_cast<std::size_t>(base + run * n)], run);
                }
            }
        }
    }
    block.fill.swap(scratch);
}

/// Returns the second derivatives (central differences, per mm²), multiplied by `factor`.
Eigen::Matrix3f curvatureAt(const TubeBlock& block, std::ptrdiff_t at, const Eigen::Vector3f& spacing, float factor)
{
    const float* f = &block.fill[static_cast<std::size_t>(at)];
    const std::array<std::ptrdiff_t, 3> step{1, block.size.x(),
                                             static_cast<std::ptrdiff_t>(block.size.x()) * block.size.y()};
    Eigen::Matrix3f hessian;
    for (int a = 0; a < 3; ++a) {
        const std::ptrdiff_t sa = step[static_cast<std::size_t>(a)];
        hessian(a, a) = factor * (f[sa] + f[-sa] - 2.0F * f[0]) / (spacing[a] * spacing[a]);
        for (int b = a + 1; b < 3; ++b) {
            const std::ptrdiff_t sb = step[static_cast<std::size_t>(b)];
            hessian(a, b) =
                factor * 0.25F * (f[sa + sb] - f[sa - sb] - f[sb - sa] + f[-sa - sb]) / (spacing[a] * spacing[b]);
            hessian(b, a) = hessian(a, b);
        }
    }
    return hessian;
}

bool isTube(const Eigen::Matrix3f& hessian)
{
    if (hessian.trace() >= -2.0F * minCurvature) {
        return false;
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(hessian, Eigen::EigenvaluesOnly);
    const Eigen::Vector3f& values = solver.eigenvalues();   // ascending: stronger transverse, weaker transverse, axial
    return values[1] < -minCurvature && values[1] < minRoundness * values[0] &&
           std::abs(values[2]) < -maxAxialRatio * values[1];
}

/// Marks tubes in one scan, block by block.
class TubeMarker {
public:
    TubeMarker(const Volume& volume, const AxisOrder& order, const LumenLevels& level, double minFill)
        : volume_(volume),
          order_(order),
          level_(level),
          minFill_(static_cast<float>(minFill)),
          voxelMm_(std::cbrt(order.geometry.spacingMm.prod()))
    {
        const double widest = scalesInVoxels.back() * voxelMm_ / order.geometry.spacingMm.minCoeff();
        margin_ = static_cast<int>(std::ceil(reachInSigmas * widest)) + 1;
        blocks_ = (order.geometry.size.array() + blockSize - 1) / blockSize;
    }

    std::size_t blockCount() const { return static_cast<std::size_t>(blocks_.prod()); }

    void mark(std::size_t blockIndex, VoxelMask& flags, const TubeBits& bits) const
    {
        const auto n = static_cast<int>(blockIndex);
        const Eigen::Vector3i low = blockSize * Eigen::Vector3i(n % blocks_.x(), n / blocks_.x() % blocks_.y(),
                                                                n / (blocks_.x() * blocks_.y()));
        const Eigen::Vector3i high = (low.array() + blockSize).min(order_.geometry.size.array());
        const std::vector<Eigen::Vector3i> candidates = candidatesIn(low, high);
        if (candidates.empty()) {
            return;
        }
        TubeBlock block = load(low, high);
        std::vector<float> scratch(block.fill.size());
        double reached = 0.0;
        for (const double scale : scalesInVoxels) {
            const double sigmaMm = scale * voxelMm_;
            const double additionalMm = std::sqrt(sigmaMm * sigmaMm - reached * reached);
            for (int axis = 0; axis < 3; ++axis) {
                smoothAlong(block, scratch, axis, additionalMm / order_.geometry.spacingMm[axis]);
            }
            if (reached == 0.0) {
                markBright(block, candidates, flags, bits);
            }
            reached = sigmaMm;
            markScale(block, candidates, static_cast<float>(sigmaMm * sigmaMm), flags, bits);
        }
    }

private:
    float fillAt(int i, int j, int k) const
    {
        const double share = (volume_.value(order_.stored(i, j, k)) - level_.tissue) / level_.contrast();
        return static_cast<float>(std::clamp(share, -0.5, 1.3));
    }

    std::vector<Eigen::Vector3i> candidatesIn(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const
    {
        std::vector<Eigen::Vector3i> found;
        for (int k = low.z(); k < high.z(); ++k) {
            for (int j = low.y(); j < high.y(); ++j) {
                for (int i = low.x(); i < high.x(); ++i) {
                    if (fillAt(i, j, k) >= minFill_) {
                        found.emplace_back(i, j, k);
                    }
                }
            }
        }
        return found;
    }

    TubeBlock load(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const
    {
        TubeBlock block{(low.array() - margin_).matrix(), (high - low).array() + 2 * margin_, {}};
        block.fill.reserve(static_cast<std::size_t>(block.size.prod()));
        const Eigen::Vector3i last = (order_.geometry.size.array() - 1).matrix();
        for (int k = 0; k < block.size.z(); ++k) {
            const int z = std::clamp(block.low.z() + k, 0, last.z());
            for (int j = 0; j < block.size.y(); ++j) {
                const int y = std::clamp(block.low.y() + j, 0, last.y());
                for (int i = 0; i < block.size.x(); ++i) {
                    block.fill.push_back(fillAt(std::clamp(block.low.x() + i, 0, last.x()), y, z));
                }
            }
        }
        return block;
    }

    static void markBright(const TubeBlock& block, const std::vector<Eigen::Vector3i>& candidates, VoxelMask& flags,
                           const TubeBits& bits)
    {
        for (const Eigen::Vector3i& voxel : candidates) {
            const Eigen::Vector3i in = voxel - block.low;
            if (block.fill[static_cast<std::size_t>(block.index(in.x(), in.y(), in.z()))] >= 0.5F) {
                std::uint8_t& flag = flags.at(voxel.x(), voxel.y(), voxel.z());
                flag = static_cast<std::uint8_t>(flag | bits.bright);
            }
        }
    }

    void markScale(const TubeBlock& block, const std::vector<Eigen::Vector3i>& candidates, float factor,
                   VoxelMask& flags, const TubeBits& bits) const
    {
        const Eigen::Vector3f spacing = order_.geometry.spacingMm.cast<float>();
        for (const Eigen::Vector3i& voxel : candidates) {
            const Eigen::Vector3i in = voxel - block.low;
            std::uint8_t& flag = flags.at(voxel.x(), voxel.y(), voxel.z());
            if ((flag & bits.tube) == 0 &&
                isTube(curvatureAt(block, block.index(in.x(), in.y(), in.z()), spacing, factor))) {
                flag = static_cast<std::uint8_t>(flag | bits.tube);
            }
        }
    }

    const Volume& volume_;
    const AxisOrder& order_;
    const LumenLevels& level_;
    float minFill_;
    double voxelMm_;
    int margin_ = 1;
    Eigen::Array3i blocks_;
};

}   // namespace

void markTubes(const Volume& volume, const AxisOrder& order, const LumenLevels& level, double minFill, VoxelMask& flags,
               const TubeBits& bits, int threads, TracingProgress& progress)
{
    const TubeMarker marker(volume, order, level, minFill);
    parallelFor(
        marker.blockCount(), threads, [&](std::size_t block) { marker.mark(block, flags, bits); },
        [&](double share) { return progress.advance(share); });
}

}   // namespace angiopose::core
