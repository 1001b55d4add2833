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
    std::array<unsigned, 27> byCorner{};
    std::array<unsigned, 27> byFace{};
    unsigned withoutCorners = 0;
    unsigned facesOfCenter = 0;
};

constexpr int apart(unsigned a, unsigned b)
{
    return a > b ? static_cast<int>(a - b) : static_cast<int>(b - a);
}

constexpr Adjacency makeAdjacency()
{
    Adjacency adjacency;
    for (unsigned a = 0; a < 27; ++a) {
        const int fromCenter = apart(a % 3, 1) + apart(a / 3 % 3, 1) + apart(a / 9, 1);
        if (fromCenter == 1) {
            adjacency.facesOfCenter |= 1U << a;
        }
        if (fromCenter == 1 || fromCenter == 2) {
            adjacency.withoutCorners |= 1U << a;
        }
        for (unsigned b = 0; b < 27; ++b) {
            const int dx = apart(a % 3, b % 3);
            const int dy = apart(a / 3 % 3, b / 3 % 3);
            const int dz = apart(a / 9, b / 9);
            if (a != b && dx <= 1 && dy <= 1 && dz <= 1) {
                adjacency.byCorner[a] |= 1U << b;
            }
            if (dx + dy + dz == 1) {
                adjacency.byFace[a] |= 1U << b;
            }
        }
    }
    return adjacency;
}

constexpr Adjacency adjacency = makeAdjacency();

/// Returns the part of `places` that is connected to `seed`.
unsigned flooded(unsigned seed, unsigned places, const std::array<unsigned, 27>& touching)
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
    if (object == 0 || flooded(lowestBit(object), object, adjacency.byCorner) != object) {
        return false;
    }
    const unsigned background = ~neighborhood & adjacency.withoutCorners;
    const unsigned faces = background & adjacency.facesOfCenter;
    return faces != 0 && (flooded(lowestBit(faces), background, adjacency.byFace) & faces) == faces;
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
class VoxelPeeler {
public:
    explicit VoxelPeeler(VoxelMask rimmed)
        : strideY_(rimmed.geometry.size.x()),
          strideZ_(strideY_ * rimmed.geometry.size.y()),
          state_(std::move(rimmed.voxels)),
          sides_{-strideY_, strideY_, 1, -1, strideZ_, -strideZ_}
    {
        findBorder();
    }

    void run(TracingProgress& progress)
    {
        const auto start = static_cast<double>(border_.size());
        double peeled = 0.0;
        bool changed = true;
        while (changed && progress.advance(peeled / (peeled + start))) {
            changed = false;
            for (const std::ptrdiff_t side : sides_) {
                const std::size_t gone = peel(side);
                changed = changed || gone > 0;
                peeled += static_cast<double>(gone);
            }
            std::erase_if(border_, [&](std::size_t p) { return state_[p] == clear; });
        }
    }

    const std::vector<std::size_t>& remaining() const { return border_; }

private:
    static constexpr int longestBite = 6;

    enum : std::uint8_t { clear = 0, inside = 1, atBorder = 2 };

    std::uint8_t stateBeside(std::size_t p, std::ptrdiff_t step) const
    {
        return state_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + step)];
    }

    void findBorder()
    {
        for (std::uint8_t& state : state_) {
            state = state != clear ? inside : clear;
        }
        for (std::size_t p = 0; p < state_.size(); ++p) {
            if (state_[p] != clear && std::any_of(sides_.begin(), sides_.end(),
                                                  [&](std::ptrdiff_t side) { return stateBeside(p, side) == clear; })) {
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
    std::size_t peel(std::ptrdiff_t side)
    {
        std::vector<std::size_t> candidates;
        for (const std::size_t p : border_) {
            if (state_[p] != clear && stateBeside(p, side) == clear && isDeletable(neighborhood(p))) {
                candidates.push_back(p);
            }
        }
        std::vector<std::size_t> exposed;
        std::size_t gone = 0;
        eaten_.clear();
        for (const std::size_t p : candidates) {
            const unsigned around = neighborhood(p);
            if (isSimple(around) && !isEatenUp(p, around)) {
                state_[p] = clear;
                ++gone;
                expose(p, exposed);
            }
        }
        mergeIntoBorder(exposed);
        return gone;
    }

    /// Returns whether a line tip must be kept in this pass. A band two voxels wide and one thick is open to one side
    /// over its whole length: processed in order of position, each voxel in turn would become the free tip of the rest
    /// until nothing is left (as in Lee's thinning), so at most six tips in a row are deleted per pass.
    bool isEatenUp(std::size_t p, unsigned around)
    {
        if (std::popcount(around & ~centerBit) > 3) {
            return false;
        }
        int before = 0;
        for (std::ptrdiff_t z = -strideZ_; z <= strideZ_; z += strideZ_) {
            for (std::ptrdiff_t y = -strideY_; y <= strideY_; y += strideY_) {
                for (std::ptrdiff_t x = -1; x <= 1; ++x) {
                    const auto found =
                        eaten_.find(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + z + y + x));
                    before = found == eaten_.end() ? before : std::max(before, found->second);
                }
            }
        }
        if (before >= longestBite) {
            return true;
        }
        eaten_[p] = before + 1;
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
    std::unordered_map<std::size_t, int> eaten_;   ///< tips deleted in this pass, with their count in the row
};

}   // namespace

std::vector<std::size_t> thinnedInPlace(VoxelMask rimmed, TracingProgress& progress)
{
    VoxelPeeler peeler(std::move(rimmed));
    peeler.run(progress);
    return peeler.remaining();
}

std::vector<std::size_t> thinned(const VoxelMask& mask, TracingProgress& progress)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    VolumeGeometry rimmedGrid;
    rimmedGrid.size = size.array() + 2;
    VoxelMask rimmed(rimmedGrid);
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y() && size.x() > 0; ++j) {
            std::copy_n(&mask.at(0, j, k), size.x(), &rimmed.at(1, j + 1, k + 1));
        }
    }
    std::vector<std::size_t> skeleton = thinnedInPlace(std::move(rimmed), progress);
    for (std::size_t& voxel : skeleton) {
        const Eigen::Vector3i at = rimmedGrid.voxelAt(voxel);
        voxel = mask.geometry.index(at.x() - 1, at.y() - 1, at.z() - 1);
    }
    return skeleton;
}

}   // namespace angiopose::core
