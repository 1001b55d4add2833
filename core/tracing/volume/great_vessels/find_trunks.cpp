#include "core/tracing/volume/great_vessels/find_trunks.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/vessel/polyline.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace angiopose::core {
namespace {

/// Centerline of a tube, in mm along the grid's axes.
struct Tube {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;
};

/// Input data of the tracking.
struct TrackingInput {
    PointOpacification fill;
    double voxelMm = 1.0;   ///< smallest resolved length
    Eigen::Vector3d highMm = Eigen::Vector3d::Zero();   ///< center of the last voxel; tracking ends at the boundary
};

constexpr double minConfidence = 0.5;   ///< a sixth of the rays may miss the wall (branch origins)
constexpr double minFlatConfidence = 0.1;   ///< for flat sections with walls all around (true lumen of a dissection)
constexpr double minClosed = 0.95;
constexpr double maxWidening = 1.3;   ///< maximum ratio of consecutive radii
constexpr double maxCenterOffset = 0.5;   ///< offset of the section's center from the expected point, in radii
constexpr double stepInRadii = 0.5;
constexpr int maxMissed = 3;   ///< maximum number of consecutive misses; a branch origin spans one or two diameters
constexpr int maxSteps = 1000;

/// Current state of the tracking.
struct TrackingState {
    Eigen::Vector3d pointMm;
    Eigen::Vector3d direction;
    double radiusMm;
};

/// Returns whether the section is round, or flattened with walls on all sides.
bool isTube(const CrossSection& section)
{
    return section.confidence >= minConfidence ||
           (section.confidence >= minFlatConfidence && section.closedFraction >= minClosed);
}

bool isConsistent(const CrossSection& section, const Eigen::Vector3d& expected, double radiusMm)
{
    return isTube(section) && section.radiusMm <= maxWidening * radiusMm &&
           radiusMm <= maxWidening * section.radiusMm &&
           (section.centerMm - expected).norm() <= maxCenterOffset * radiusMm;
}

/// Returns the start section across the vessel: the smallest of the round sections in 13 directions.
std::optional<TrackingState> findStart(const Eigen::Vector3d& startMm, double radiusMm, const TrackingInput& input)
{
    std::optional<TrackingState> best;
    for (int n = 14; n < 27; ++n) {   // one of each pair of opposite neighbors
        const Eigen::Vector3i neighbor(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const Eigen::Vector3d direction = neighbor.cast<double>().normalized();
        const CrossSection section = measureCrossSection({startMm, direction, radiusMm, input.voxelMm}, input.fill);
        if (section.confidence >= minConfidence && (!best || section.radiusMm < best->radiusMm)) {
            best = TrackingState{section.centerMm, direction, section.radiusMm};
        }
    }
    return best;
}

/// Tracks in one direction from the start, excluding the start.
Tube trackOneDirection(TrackingState state, const TrackingInput& input)
{
    Tube tube;
    Eigen::Vector3d last = state.pointMm;
    int missed = 0;
    for (int step = 0; step < maxSteps && missed <= maxMissed; ++step) {
        const Eigen::Vector3d expected =
            state.pointMm + std::max(input.voxelMm, stepInRadii * state.radiusMm) * state.direction;
        if ((expected.array() < 0.0).any() || (expected.array() > input.highMm.array()).any()) {
            break;
        }
        const CrossSection section =
            measureCrossSection({expected, state.direction, state.radiusMm, input.voxelMm}, input.fill);
        if (!isConsistent(section, expected, state.radiusMm)) {
            ++missed;
            state.pointMm = expected;
            continue;
        }
        missed = 0;
        const Eigen::Vector3d way = (section.centerMm - last).normalized();
        state = {section.centerMm, (state.direction + way).normalized(), 0.5 * (state.radiusMm + section.radiusMm)};
        last = section.centerMm;
        tube.pointsMm.push_back(section.centerMm);
        tube.radiusMm.push_back(section.radiusMm);
    }
    return tube;
}

/// Tracks a vessel of about `radiusMm` in both directions from `startMm`, section by section, as long as the sections
/// are round and the width changes slowly. Returns at least the start.
Tube trackTube(const Eigen::Vector3d& startMm, double radiusMm, const TrackingInput& input)
{
    const auto start = findStart(startMm, radiusMm, input);
    if (!start) {
        return {{startMm}, {radiusMm}};
    }
    Tube tube = trackOneDirection({start->pointMm, -start->direction, start->radiusMm}, input);
    std::reverse(tube.pointsMm.begin(), tube.pointsMm.end());
    std::reverse(tube.radiusMm.begin(), tube.radiusMm.end());
    tube.pointsMm.push_back(start->pointMm);
    tube.radiusMm.push_back(start->radiusMm);
    const Tube ahead = trackOneDirection(*start, input);
    tube.pointsMm.insert(tube.pointsMm.end(), ahead.pointsMm.begin(), ahead.pointsMm.end());
    tube.radiusMm.insert(tube.radiusMm.end(), ahead.radiusMm.begin(), ahead.radiusMm.end());
    return tube;
}

constexpr double minRadiusInBlocks = 1.3;   ///< in blocks, or in voxels if larger; thinner vessels are not detected
constexpr double minSlenderness = 3.0;   ///< minimum slenderness; a single heart chamber has 2
constexpr double typicalMaxRadiusMm = 15.0;   ///< radius of the widest arteries; larger chambers score no higher
constexpr double maxSlenderness = 20.0;   ///< cap in the score; otherwise thin vessels would win
constexpr std::size_t minPointsOfTrunk = 6;
constexpr std::uint8_t inTube = 1;
constexpr std::uint8_t inTrunk = 2;

/// Returns the local centers of the lumen, widest first.
std::vector<std::uint32_t> centersOf(const DistanceMap& distances, double minMm)
{
    const VolumeGeometry& grid = distances.geometry;
    std::vector<std::uint32_t> centers;
    for (int k = 1; k + 1 < grid.size.z(); ++k) {
        for (int j = 1; j + 1 < grid.size.y(); ++j) {
            for (int i = 1; i + 1 < grid.size.x(); ++i) {
                const std::size_t at = grid.index(i, j, k);
                if (distances.mm(at) < minMm) {
                    continue;
                }
                const auto row = static_cast<std::size_t>(grid.size.x());
                const std::size_t slice = row * static_cast<std::size_t>(grid.size.y());
                const std::uint16_t here = distances.units[at];
                int sides = 0;   // number of axes along which the distance is a local maximum
                for (const std::size_t step : {std::size_t{1}, row, slice}) {
                    sides += here >= distances.units[at - step] && here >= distances.units[at + step] ? 1 : 0;
                }
                if (sides >= 2) {
                    centers.push_back(static_cast<std::uint32_t>(at));
                }
            }
        }
    }
    std::stable_sort(centers.begin(), centers.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return distances.units[a] > distances.units[b]; });
    return centers;
}

/// Marks the voxels inside the tube, because tracking from them would find the same tube again.
void mark(VoxelMask& marked, const Tube& tube, std::uint8_t value)
{
    const VolumeGeometry& grid = marked.geometry;
    for (std::size_t n = 0; n < tube.pointsMm.size(); ++n) {
        const Eigen::Array3d middle = tube.pointsMm[n].cwiseQuotient(grid.spacingMm);
        const Eigen::Array3d reach = tube.radiusMm[n] / grid.spacingMm.array();
        const Eigen::Array3i low = (middle - reach).ceil().max(0.0).cast<int>();
        const Eigen::Array3i high = (middle + reach).floor().min(grid.size.cast<double>().array() - 1.0).cast<int>();
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                for (int i = low.x(); i <= high.x(); ++i) {
                    if ((grid.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k)) - tube.pointsMm[n]).norm() <=
                        tube.radiusMm[n]) {
                        marked.at(i, j, k) = std::max(marked.at(i, j, k), value);
                    }
                }
            }
        }
    }
}

/// Returns whether most of the tube lies in trunks found before.
bool isRepeated(const Tube& tube, const VoxelMask& marked)
{
    const VolumeGeometry& grid = marked.geometry;
    const auto insideCount =
        std::count_if(tube.pointsMm.begin(), tube.pointsMm.end(), [&](const Eigen::Vector3d& point) {
            const Eigen::Vector3i at = point.cwiseQuotient(grid.spacingMm).array().round().cast<int>();
            return grid.contains(at) && marked.at(at.x(), at.y(), at.z()) == inTrunk;
        });
    return 2 * insideCount > static_cast<std::ptrdiff_t>(tube.pointsMm.size());
}

/// Returns whether a trunk is long enough for its width: wider trunks must be more slender, because two heart chambers
/// in a row are wider than arteries and have a slenderness of 4.
bool isTrunk(const Trunk& trunk)
{
    const double widthExcess = std::max(1.0, trunk.medianRadiusMm() / typicalMaxRadiusMm);
    return trunk.radiusMm.size() >= minPointsOfTrunk &&
           trunk.slenderness() >= minSlenderness * widthExcess * widthExcess;
}

}   // namespace

double Trunk::medianRadiusMm() const
{
    return medianOf(radiusMm);
}

double Trunk::slenderness() const
{
    return polylineLength<3>(pointsInPatient) / *std::max_element(radiusMm.begin(), radiusMm.end());
}

double Trunk::score() const
{
    double sideAreaMm2 = 0.0;
    double lowMm = pointsInPatient.front().z();
    double highMm = lowMm;
    for (std::size_t n = 1; n < pointsInPatient.size(); ++n) {
        sideAreaMm2 += std::min(radiusMm[n], typicalMaxRadiusMm) * (pointsInPatient[n] - pointsInPatient[n - 1]).norm();
        lowMm = std::min(lowMm, pointsInPatient[n].z());
        highMm = std::max(highMm, pointsInPatient[n].z());
    }
    const double widest = *std::max_element(radiusMm.begin(), radiusMm.end());
    return sideAreaMm2 * std::min((highMm - lowMm) / widest, maxSlenderness) * std::pow(std::min(fill, 1.0), 2);
}

std::vector<Trunk> findTrunks(const BlockOpacification& blocks, const DistanceMap& distances, TracingProgress& progress)
{
    const VolumeGeometry& grid = distances.geometry;
    const TrackingInput input{blocks.fill(), blocks.resolutionMm,
                              grid.spacingMm.cwiseProduct((grid.size.array() - 1).cast<double>().matrix())};
    VoxelMask marked(grid);
    std::vector<Trunk> trunks;
    const std::vector<std::uint32_t> centers = progress.isStopped()
                                                   ? std::vector<std::uint32_t>()
                                                   : centersOf(distances, minRadiusInBlocks * blocks.resolutionMm);
    for (const std::uint32_t middle : centers) {
        if (marked.voxels[middle] != 0) {
            continue;
        }
        if (!progress.advance(0.0)) {
            break;
        }
        const Tube tube =
            trackTube(grid.spacingMm.cwiseProduct(grid.voxelAt(middle).cast<double>()), distances.mm(middle), input);
        Trunk trunk{{}, tube.radiusMm, 0.0};
        for (const Eigen::Vector3d& point : tube.pointsMm) {
            trunk.fill += input.fill(point) / static_cast<double>(tube.pointsMm.size());
            trunk.pointsInPatient.emplace_back(grid.originInPatient + grid.direction * point);
        }
        const bool isFound = isTrunk(trunk) && !isRepeated(tube, marked);
        mark(marked, tube, isFound ? inTrunk : inTube);
        if (isFound) {
            trunks.push_back(std::move(trunk));
        }
    }
    std::stable_sort(trunks.begin(), trunks.end(),
                     [](const Trunk& a, const Trunk& b) { return a.score() > b.score(); });
    return trunks;
}

}   // namespace angiopose::core
