#include "core/tracing/volume/voxels/distance_map.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double unitsPerVoxel = 256.0;
constexpr std::uint16_t maxUnits = std::numeric_limits<std::uint16_t>::max();

std::uint16_t inUnits(double value)
{
    return static_cast<std::uint16_t>(std::min(std::round(value), static_cast<double>(maxUnits)));
}

/// Computes the distance along one row to the nearest clear voxel in that row.
void measureRow(const std::uint8_t* mask, std::uint16_t* units, int count, double step)
{
    int last = -count - 1;   // last clear voxel passed
    const auto distance = [&](int voxels) { return voxels > count ? maxUnits : inUnits(step * voxels); };
    for (int i = 0; i < count; ++i) {
        last = mask[i] == 0 ? i : last;
        units[i] = distance(i - last);
    }
    last = 2 * count + 1;
    for (int i = count - 1; i >= 0; --i) {
        last = mask[i] == 0 ? i : last;
        units[i] = std::min(units[i], distance(last - i));
    }
}

/// Lower envelope of the parabolas (x - i)² step² + d(i)².
class Envelope {
public:
    explicit Envelope(int count)
        : squared_(static_cast<std::size_t>(count)), apex_(squared_.size()), from_(squared_.size() + 1)
    {
    }

    void replace(std::uint16_t* units, std::ptrdiff_t stride, int count, double step)
    {
        bool hasDistance = false;
        for (int i = 0; i < count; ++i) {
            const std::uint16_t value = units[i * stride];
            squared_[static_cast<std::size_t>(i)] =
                value == maxUnits ? infinite : static_cast<double>(value) * static_cast<double>(value);
            hasDistance = hasDistance || value != 0;
        }
        if (!hasDistance) {
            return;
        }
        const double squaredStep = step * step;
        const std::size_t apexes = build(count, squaredStep);
        if (apexes == 0) {
            return;   // the row has no clear voxel
        }
        std::size_t a = 0;
        for (int i = 0; i < count; ++i) {
            while (a + 1 < apexes && from_[a + 1] < i) {
                ++a;
            }
            const double fromApex = i - apex_[a];
            units[i * stride] =
                inUnits(std::sqrt(fromApex * fromApex * squaredStep + squared_[static_cast<std::size_t>(apex_[a])]));
        }
    }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    std::size_t build(int count, double squaredStep)
    {
        std::size_t apexes = 0;
        for (int i = 0; i < count; ++i) {
            const double height = squared_[static_cast<std::size_t>(i)];
            if (height == infinite) {
                continue;
            }
            double intersection = -infinite;
            while (apexes > 0) {
                const int other = apex_[apexes - 1];
                const double otherHeight = squared_[static_cast<std::size_t>(other)];
                intersection = 0.5 * (i + other + (height - otherHeight) / (squaredStep * (i - other)));
                if (intersection > from_[apexes - 1]) {
                    break;
                }
                --apexes;
            }
            from_[apexes] = apexes == 0 ? -infinite : intersection;
            apex_[apexes++] = i;
        }
        return apexes;
    }

    std::vector<double> squared_;
    std::vector<int> apex_;
    std::vector<double> from_;
};

}   // namespace

DistanceMap distanceMap(const VoxelMask& mask, int threads, TracingProgress& progress)
{
    const VolumeGeometry& grid = mask.geometry;
    DistanceMap map{grid, grid.spacingMm.minCoeff() / unitsPerVoxel, {}};
    map.units.resize(mask.voxels.size());
    const Eigen::Vector3d step = grid.spacingMm / map.unitMm;
    const auto strideY = static_cast<std::ptrdiff_t>(grid.size.x());
    const auto strideZ = strideY * grid.size.y();
    const auto slices = static_cast<std::size_t>(grid.size.z());
    const bool isDone = parallelFor(
        slices, threads,
        [&](std::size_t k) {
            for (int j = 0; j < grid.size.y(); ++j) {
                const std::size_t row = grid.index(0, j, static_cast<int>(k));
                measureRow(&mask.voxels[row], &map.units[row], grid.size.x(), step.x());
            }
            Envelope envelope(grid.size.y());
            for (int i = 0; i < grid.size.x(); ++i) {
                envelope.replace(&map.units[grid.index(i, 0, static_cast<int>(k))], strideY, grid.size.y(), step.y());
            }
        },
        [&](double share) { return progress.advance(0.6 * share); });
    if (isDone) {
        parallelFor(
            static_cast<std::size_t>(grid.size.y()), threads,
            [&](std::size_t j) {
                Envelope envelope(grid.size.z());
                for (int i = 0; i < grid.size.x(); ++i) {
                    envelope.replace(&map.units[grid.index(i, static_cast<int>(j), 0)], strideZ, grid.size.z(),
                                     step.z());
                }
            },
            [&](double share) { return progress.advance(0.6 + 0.4 * share); });
    }
    return map;
}

}   // namespace angiopose::core
