#include "core/tracing/volume/stented_lumen.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/axis_order.h"
#include "core/tracing/volume/distance_map.h"
#include "core/tracing/volume/wide_basins.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace core {
namespace {

constexpr double leastFill = 0.5;   ///< the wall between wires
constexpr double leastBlood = 0.8;   ///< of what is seen between wires
constexpr double leastNeck = 0.45;   ///< of the thinner lumen's radius, within one vessel
constexpr double leastOpenShare = 0.5;   ///< of where two pieces meet, in one vessel
constexpr double mostOpeningInRadii = 4.0;   ///< of a branch; the lumens of a torn aorta meet over more
constexpr double besideMm = 10.0;   ///< around an opening, to tell the blood by
constexpr std::size_t leastInner = 12;   ///< voxels that tell it
constexpr double mostDifference = 0.15;   ///< between blood of one vessel

using Label = std::uint32_t;
using Pair = std::pair<Label, Label>;

/// Where two pieces meet.
struct Contact {
    std::vector<Eigen::Vector3i> places;
    std::vector<Eigen::Vector3i> open;   ///< those of them where blood is seen

    VoxelBox box() const
    {
        VoxelBox box{open.front(), open.front()};
        for (const Eigen::Vector3i& at : open) {
            box.low = box.low.cwiseMin(at);
            box.high = box.high.cwiseMax(at);
        }
        return box;
    }
};

VoxelBox boxAroundAll(const std::vector<VoxelPiece>& pieces, const VolumeGeometry& grid)
{
    VoxelBox all{grid.size, Eigen::Vector3i::Zero()};
    for (const VoxelPiece& piece : pieces) {
        const VoxelBox box = boxAround(piece, grid, besideMm);
        all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    }
    return all;
}

/// Grows the pieces of the lumen around stents.
class Widening {
public:
    Widening(const VoxelMask& lumen, const StentWires& wires, const VoxelFill& fill, TracingProgress& progress)
        : lumen_(lumen),
          isBeside_(wires.isBeside),
          fill_(fill),
          box_(boxAroundAll(wires.pieces, lumen.geometry)),
          wires_(cropped(lumen.geometry, box_)),
          labels_(wires_.geometry)
    {
        for (const VoxelPiece& piece : wires.pieces) {
            for (const std::uint32_t voxel : piece) {
                const Eigen::Vector3i at = lumen.geometry.voxelAt(voxel) - box_.low;
                wires_.at(at.x(), at.y(), at.z()) = 1;
            }
        }
        labelPieces(progress);
    }

    /// One voxel further.
    void advance()
    {
        std::vector<Eigen::Vector3i> next;
        for (const Eigen::Vector3i& from : shore_) {
            eachBeside(from, [&](const Eigen::Vector3i& to) {
                if (labelAt(to) == 0 && leads(from, to) && !isParting(to, labelAt(from))) {
                    take(to, labelAt(from));
                    next.push_back(to);
                }
            });
        }
        shore_.swap(next);
    }

    /// Sets what was left between pieces of one vessel, unless yet another piece is beside it.
    void join()
    {
        std::map<Label, Label> vessels = piecesToVessels();
        for (const auto& [pair, contact] : contacts_) {
            const Label vessel = vessels[pair.first];
            for (const Eigen::Vector3i& at : contact.places) {
                bool isWithin = vessels[pair.second] == vessel;
                eachLabelAround(
                    at, [&](Label its, const Eigen::Vector3i&) { isWithin = isWithin && vessels[its] == vessel; });
                if (isWithin && labelAt(at) == 0) {
                    take(at, pair.first);
                }
            }
        }
    }

    VoxelPiece taken() &&
    {
        std::sort(taken_.begin(), taken_.end());
        return std::move(taken_);
    }

private:
    template <class Visit>
    void eachBeside(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                const Eigen::Vector3i beside = at + step * Eigen::Vector3i::Unit(axis);
                if (labels_.geometry.contains(beside)) {
                    visit(beside);
                }
            }
        }
    }

    /// Those of the places around that have one.
    template <class Visit>
    void eachLabelAround(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i beside = at + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (labels_.geometry.contains(beside) && labelAt(beside) != 0) {
                visit(labelAt(beside), beside);
            }
        }
    }

    std::uint8_t lumenAt(const Eigen::Vector3i& at) const
    {
        return lumen_.at(at.x() + box_.low.x(), at.y() + box_.low.y(), at.z() + box_.low.z());
    }
    double fillAt(const Eigen::Vector3i& at) const
    {
        return fill_(at.x() + box_.low.x(), at.y() + box_.low.y(), at.z() + box_.low.z());
    }
    bool isBeside(const Eigen::Vector3i& at) const
    {
        return isBeside_(at.x() + box_.low.x(), at.y() + box_.low.y(), at.z() + box_.low.z());
    }
    bool isWire(const Eigen::Vector3i& at) const { return wires_.at(at.x(), at.y(), at.z()) != 0; }
    Label labelAt(const Eigen::Vector3i& at) const { return labels_.at(at.x(), at.y(), at.z()); }

    void take(const Eigen::Vector3i& at, Label label)
    {
        const Eigen::Vector3i whole = at + box_.low;
        taken_.push_back(static_cast<std::uint32_t>(lumen_.geometry.index(whole.x(), whole.y(), whole.z())));
        labels_.at(at.x(), at.y(), at.z()) = label;
    }

    /// What hangs together on ways about as wide as itself: a tear in a flap is narrow beside the lumens.
    void labelPieces(TracingProgress& progress)
    {
        VoxelMask part(labels_.geometry);
        for (std::size_t voxel = 0; voxel < part.voxels.size(); ++voxel) {
            part.voxels[voxel] = lumenAt(part.geometry.voxelAt(voxel)) != 0 ? 1 : 0;
        }
        const DistanceMap distances = distanceMap(part, 1, progress);
        labels_.voxels = wideBasins(distances, leastNeck);
        for (std::size_t voxel = 0; voxel < part.voxels.size(); ++voxel) {
            if (part.voxels[voxel] != 0) {
                double& radiusMm = radiusMm_[labels_.voxels[voxel]];
                radiusMm = std::max(radiusMm, distances.mm(voxel));
                shore_.push_back(part.geometry.voxelAt(voxel));
            }
        }
    }

    /// Up to the crest of a wire, or between wires.
    bool leads(const Eigen::Vector3i& from, const Eigen::Vector3i& to) const
    {
        const double fill = fillAt(to);
        const bool isRising = isWire(to) && fill > fillAt(from);
        return fill >= leastFill && (isRising || !isWire(from)) && isBeside(to);
    }

    /// Whether it lies between different pieces; notes where they meet and where blood is seen there.
    bool isParting(const Eigen::Vector3i& at, Label label)
    {
        const bool isBlood = !isWire(at) && fillAt(at) >= leastBlood;
        std::map<Label, bool> others;   // whether blood is seen on the way
        eachLabelAround(at, [&](Label its, const Eigen::Vector3i& beside) {
            if (its != label) {
                others[its] = others[its] || (isBlood && !isWire(beside));
            }
        });
        for (const auto& [other, isOpen] : others) {
            Contact& contact = contacts_[std::minmax(label, other)];
            contact.places.push_back(at);
            if (isOpen) {
                contact.open.push_back(at);
            }
        }
        return !others.empty();
    }

    std::map<Label, Label> piecesToVessels() const
    {
        std::map<Label, Label> vessels;
        for (const auto& [label, radiusMm] : radiusMm_) {
            vessels[label] = label;
        }
        for (const auto& [pair, contact] : contacts_) {
            if (isOneVessel(pair, contact)) {
                const Label joined = vessels[pair.second];
                for (auto& [label, vessel] : vessels) {
                    vessel = vessel == joined ? vessels[pair.first] : vessel;
                }
            }
        }
        return vessels;
    }

    /// One lumen that wires cross, or a branch that leaves between them.
    bool isOneVessel(const Pair& pair, const Contact& contact) const
    {
        if (contact.open.empty() || !isSameBlood(pair, contact)) {
            return false;
        }
        const double openShare = static_cast<double>(contact.open.size()) / static_cast<double>(contact.places.size());
        const double thinnerMm = std::min(radiusMm_.at(pair.first), radiusMm_.at(pair.second));
        return openShare >= leastOpenShare || spanMm(contact) <= mostOpeningInRadii * thinnerMm;
    }

    double spanMm(const Contact& contact) const
    {
        const VoxelBox box = contact.box();
        return labels_.geometry.spacingMm.cwiseProduct((box.high - box.low).cast<double>()).norm();
    }

    /// Or one of them is too thin to tell.
    bool isSameBlood(const Pair& pair, const Contact& contact) const
    {
        const VoxelBox box = contact.box();
        const Eigen::Vector3i reach = (besideMm / labels_.geometry.spacingMm.array()).ceil().cast<int>();
        const Fills first = fillsOf(pair.first, box.low - reach, box.high + reach);
        const Fills second = fillsOf(pair.second, box.low - reach, box.high + reach);
        if (first.inner.size() < leastInner || second.inner.size() < leastInner) {
            return std::min(quantile(first.all, 0.9), quantile(second.all, 0.9)) >= leastBlood;
        }
        return std::abs(medianOf(first.inner) - medianOf(second.inner)) <= mostDifference;
    }

    struct Fills {
        std::vector<double> all;
        std::vector<double> inner;
    };

    Fills fillsOf(Label label, const Eigen::Vector3i& from, const Eigen::Vector3i& to) const
    {
        Fills fills;
        const Eigen::Vector3i low = from.cwiseMax(0);
        const Eigen::Vector3i high = to.cwiseMin((labels_.geometry.size.array() - 1).matrix());
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                for (int i = low.x(); i <= high.x(); ++i) {
                    const Eigen::Vector3i at(i, j, k);
                    if (labelAt(at) != label || isWire(at)) {
                        continue;
                    }
                    fills.all.push_back(fillAt(at));
                    if (lumenAt(at) > 1) {
                        fills.inner.push_back(fills.all.back());
                    }
                }
            }
        }
        return fills;
    }

    const VoxelMask& lumen_;
    const std::function<bool(int, int, int)>& isBeside_;
    const VoxelFill& fill_;
    VoxelBox box_;   ///< around the stents; all places are counted from its low corner
    VoxelMask wires_;
    VoxelGrid<Label> labels_;   ///< of the pieces, 0 elsewhere
    std::vector<Eigen::Vector3i> shore_;   ///< what was taken last
    VoxelPiece taken_;   ///< in the whole scan
    std::map<Label, double> radiusMm_;   ///< of the pieces where they are widest
    std::map<Pair, Contact> contacts_;   ///< by the pieces that meet
};

}   // namespace

VoxelPiece lumenBesideWires(const VoxelMask& lumen, const StentWires& wires, const VoxelFill& fill, int steps,
                            TracingProgress& progress)
{
    if (wires.pieces.empty()) {
        return {};
    }
    Widening widening(lumen, wires, fill, progress);
    for (int n = 0; n < steps && progress.advance(0.0); ++n) {
        widening.advance();
    }
    if (!progress.isStopped()) {
        widening.join();
    }
    return std::move(widening).taken();
}

}   // namespace core
