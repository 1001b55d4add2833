#include "core/tracing/volume/voxels/thin_volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>

namespace angiopose::core {
namespace {

// A neighborhood is stored in 27 bits: bit x + 3 y + 9 z for the steps x - 1, y - 1, z - 1; the center is bit 13.
constexpr unsigned centerBit = 1U << 13U;

/// Neighbors of each of the 27 positions for 26- and 6-connectivity, and the 18-neighborhood of the center.
struct Adjacency {
    std::array<unsigned, 27> neighbors26{};
    std::array<unsigned, 27> neighbors6{};
    unsigned neighbors18 = 0;
    unsigned faceNeighbors = 0;
};

constexpr int distance(unsigned a, unsigned b)
{
    return a > b ? static_cast<int>(a - b) : static_cast<int>(b - a);
}

constexpr Adjacency makeAdjacency()
{
    Adjacency adjacency;
    for (unsigned a = 0; a < 27; ++a) {
        const int fromCenter = distance(a % 3, 1) + distance(a / 3 % 3, 1) + distance(a / 9, 1);
        if (fromCenter == 1) {
            adjacency.faceNeighbors |= 1U << a;
        }
        if (fromCenter == 1 || fromCenter == 2) {
            adjacency.neighbors18 |= 1U << a;
        }
        for (unsigned b = 0; b < 27; ++b) {
            const int dx = distance(a % 3, b % 3);
            const int dy = distance(a / 3 % 3, b / 3 % 3);
            const int dz = distance(a / 9, b / 9);
            if (a != b && dx <= 1 && dy <= 1 && dz <= 1) {
                adjacency.neighbors26[a] |= 1U << b;
            }
            if (dx + dy + dz == 1) {
                adjacency.neighbors6[a] |= 1U << b;
            }
        }
    }
    return adjacency;
}

constexpr Adjacency adjacency = makeAdjacency();

/// Returns the part of `places` that is connected to `seed`.
unsigned floodFill(unsigned seed, unsigned places, const std::array<unsigned, 27>& touching)
{
    unsigned reached = seed;
    unsigned front = seed;
    while (front != 0) {
        unsigned next = 0;
        for (; front != 0; front &= front - 1) {
            next |= touching[static_cast<std::size_t>(std::countr_zero(front))];
        }
        front = next & places & ~reached;
        reached |= front;
    }
    return reached;
}

constexpr unsigned lowestBit(unsigned bits)
{
    return bits & (~bits + 1U);
}

/// Returns whether the center can be deleted without changing the topology (Bertrand and Malandain 1994): it has one
/// adjacent object component, and one background component that shares a face with it.
bool isSimple(unsigned neighborhood)
{
    const unsigned object = neighborhood & ~centerBit;
    if (object == 0 || floodFill(lowestBit(object), object, adjacency.neighbors26) != object) {
        return false;
    }
    const unsigned background = ~neighborhood & adjacency.neighbors18;
    const unsigned faces = background & adjacency.faceNeighbors;
    return faces != 0 && (floodFill(lowestBit(faces), background, adjacency.neighbors6) & faces) == faces;
}

bool isEndOfLine(unsigned neighborhood)
{
    return std::popcount(neighborhood & ~centerBit) <= 1;
}

bool isDeletable(unsigned neighborhood)
{
    return !isEndOfLine(neighborhood) && isSimple(neighborhood);
}

/// Thins a mask with a clear border, where every voxel has all its neighbors; keeps the border voxels of the mask in
/// ascending order.
class VoxelThinner {
public:
    explicit VoxelThinner(VoxelMask padded)
        : strideY_(padded.geometry.size.x()),
          strideZ_(strideY_ * padded.geometry.size.y()),
          state_(std::move(padded.voxels)),
          sides_{-strideY_, strideY_, 1, -1, strideZ_, -strideZ_}
    {
        findBorder();
    }

    void run(TracingProgress& progress)
    {
        const auto start = static_cast<double>(border_.size());
        double deletedTotal = 0.0;
        bool changed = true;
        while (changed && progress.advance(deletedTotal / (deletedTotal + start))) {
            changed = false;
            for (const std::ptrdiff_t side : sides_) {
                const std::size_t deletedCount = thinFromSide(side);
                changed = changed || deletedCount > 0;
                deletedTotal += static_cast<double>(deletedCount);
            }
            std::erase_if(border_, [&](std::size_t p) { return state_[p] == clear; });
        }
    }

    const std::vector<std::size_t>& remaining() const { return border_; }

private:
    static constexpr int maxTipsPerPass = 6;

    enum : std::uint8_t { clear = 0, inside = 1, atBorder = 2 };

    std::uint8_t neighborState(std::size_t p, std::ptrdiff_t step) const
    {
        return state_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + step)];
    }

    void findBorder()
    {
        for (std::uint8_t& state : state_) {
            state = state != clear ? inside : clear;
        }
        for (std::size_t p = 0; p < state_.size(); ++p) {
            if (state_[p] != clear && std::any_of(sides_.begin(), sides_.end(), [&](std::ptrdiff_t side) {
                    return neighborState(p, side) == clear;
                })) {
                state_[p] = atBorder;
                border_.push_back(p);
            }
        }
    }

    unsigned neighborhood(std::size_t p) const
    {
        unsigned bits = 0;
        unsigned bit = 0;
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                const std::uint8_t* row = &state_[p] + z * strideZ_ + y * strideY_ - 1;
                for (int x = 0; x < 3; ++x, ++bit) {
                    bits |= static_cast<unsigned>(row[x] != clear) << bit;
                }
            }
        }
        return bits;
    }

    /// Deletes voxels that are open to one side. All candidates are collected first, then each is checked again,
    /// because two neighbors that are each deletable alone must not be deleted together.
    std::size_t thinFromSide(std::ptrdiff_t side)
    {
        std::vector<std::size_t> candidates;
        for (const std::size_t p : border_) {
            if (state_[p] != clear && neighborState(p, side) == clear && isDeletable(neighborhood(p))) {
                candidates.push_back(p);
            }
        }
        std::vector<std::size_t> exposed;
        std::size_t deletedCount = 0;
        deletedTips_.clear();
        for (const std::size_t p : candidates) {
            const unsigned around = neighborhood(p);
            if (isSimple(around) && !mustKeepTip(p, around)) {
                state_[p] = clear;
                ++deletedCount;
                expose(p, exposed);
            }
        }
        mergeIntoBorder(exposed);
        return deletedCount;
    }

    /// Returns whether a line tip must be kept in this pass. A band two voxels wide and one thick is open to one side
    /// over its whole length: processed in order of position, each voxel in turn would become the free tip of the rest
    /// until nothing is left (as in Lee's thinning), so at most six tips in a row are deleted per pass.
    bool mustKeepTip(std::size_t p, unsigned around)
    {
        if (std::popcount(around & ~centerBit) > 3) {
            return false;
        }
        int before = 0;
        for (std::ptrdiff_t z = -strideZ_; z <= strideZ_; z += strideZ_) {
            for (std::ptrdiff_t y = -strideY_; y <= strideY_; y += strideY_) {
                for (std::ptrdiff_t x = -1; x <= 1; ++x) {
                    const auto found =
                        deletedTips_.find(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + z + y + x));
                    before = found == deletedTips_.end() ? before : std::max(before, found->second);
                }
            }
        }
        if (before >= maxTipsPerPass) {
            return true;
        }
        deletedTips_[p] = before + 1;
        return false;
    }

    void expose(std::size_t p, std::vector<std::size_t>& exposed)
    {
        for (const std::ptrdiff_t side : sides_) {
            const auto q = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + side);
            if (state_[q] == inside) {
                state_[q] = atBorder;
                exposed.push_back(q);
            }
        }
    }

    void mergeIntoBorder(std::vector<std::size_t>& exposed)
    {
        std::sort(exposed.begin(), exposed.end());
        const auto middle = static_cast<std::ptrdiff_t>(border_.size());
        border_.insert(border_.end(), exposed.begin(), exposed.end());
        std::inplace_merge(border_.begin(), border_.begin() + middle, border_.end());
    }

    std::ptrdiff_t strideY_;
    std::ptrdiff_t strideZ_;
    std::vector<std::uint8_t> state_;
    std::array<std::ptrdiff_t, 6> sides_;
    std::vector<std::size_t> border_;
    std::unordered_map<std::size_t, int> deletedTips_;   ///< tips deleted in this pass, with their count in the row
};

}   // namespace

std::vector<std::size_t> skeletonizeInPlace(VoxelMask padded, TracingProgress& progress)
{
    VoxelThinner thinner(std::move(padded));
    thinner.run(progress);
    return thinner.remaining();
}

std::vector<std::size_t> skeletonize(const VoxelMask& mask, TracingProgress& progress)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    VolumeGeometry paddedGrid;
    paddedGrid.size = size.array() + 2;
    VoxelMask padded(paddedGrid);
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y() && size.x() > 0; ++j) {
            std::copy_n(&mask.at(0, j, k), size.x(), &padded.at(1, j + 1, k + 1));
        }
    }
    std::vector<std::size_t> skeleton = skeletonizeInPlace(std::move(padded), progress);
    for (std::size_t& voxel : skeleton) {
        const Eigen::Vector3i at = paddedGrid.voxelAt(voxel);
        voxel = mask.geometry.index(at.x() - 1, at.y() - 1, at.z() - 1);
    }
    return skeleton;
}

}   // namespace angiopose::core
