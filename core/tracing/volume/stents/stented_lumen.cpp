#include "core/tracing/volume/stents/stented_lumen.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/stents/wide_basins.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double minFillBetweenStruts = 0.5;   ///< minimum opacification for growing between struts
constexpr double minLumenOpacification = 0.8;   ///< minimum opacification of lumen visible between struts
constexpr double minNeckWithin = 0.45;   ///< minimum neck within one vessel, relative to the thinner lumen's radius
constexpr double minOpenShare = 0.5;   ///< minimum open fraction of a contact area within one vessel
constexpr double maxOpeningInRadii = 4.0;   ///< maximum span of a branch opening; dissection lumens meet over more
constexpr double besideOpeningMm = 10.0;   ///< radius around an opening for comparing the opacification
constexpr std::size_t minInnerOfLumen = 12;   ///< minimum voxels for the comparison
constexpr double maxDifference = 0.15;   ///< maximum difference of opacification within one vessel

using Label = StentSite::Label;
using Pair = std::pair<Label, Label>;

/// Contact area of two components.
struct Contact {
    std::vector<Eigen::Vector3i> places;
    std::vector<Eigen::Vector3i> open;   ///< positions where opacified lumen is visible

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

/// Grows the lumen components around stents.
class LumenGrowth {
public:
    LumenGrowth(const VoxelMask& lumen, const StentStruts& wires, const VoxelOpacification& opacification,
                TracingProgress& progress)
        : site_(lumen, wires, opacification, besideOpeningMm)
    {
        labelComponents(progress);
    }

    /// Grows by one voxel.
    void advance()
    {
        std::vector<Eigen::Vector3i> next;
        for (const Eigen::Vector3i& from : front_) {
            site_.forEachFaceNeighbor(from, [&](const Eigen::Vector3i& to) {
                if (site_.labelAt(to) == 0 && canGrow(from, to) && !isBetweenComponents(to, site_.labelAt(from))) {
                    add(to, site_.labelAt(from));
                    next.push_back(to);
                }
            });
        }
        front_.swap(next);
    }

    /// Closes the gaps between components of the same vessel, except next to other vessels.
    void fillGaps()
    {
        std::map<Label, Label> vessels = groupIntoVessels();
        for (const auto& [pair, contact] : contacts_) {
            const Label vessel = vessels[pair.first];
            for (const Eigen::Vector3i& at : contact.places) {
                bool isWithin = vessels[pair.second] == vessel;
                site_.forEachLabeledNeighbor(
                    at, [&](Label its, const Eigen::Vector3i&) { isWithin = isWithin && vessels[its] == vessel; });
                if (isWithin && site_.labelAt(at) == 0) {
                    add(at, pair.first);
                }
            }
        }
    }

    VoxelComponent added() &&
    {
        std::sort(added_.begin(), added_.end());
        return std::move(added_);
    }

private:
    void add(const Eigen::Vector3i& at, Label label)
    {
        added_.push_back(site_.scanIndex(at));
        site_.labels.at(at.x(), at.y(), at.z()) = label;
    }

    /// Labels lumen components; parts connected by paths about as wide as themselves get the same label. A tear in a
    /// dissection flap is narrow compared with the lumens.
    void labelComponents(TracingProgress& progress)
    {
        VoxelMask part(site_.geometry());
        for (std::size_t voxel = 0; voxel < part.voxels.size(); ++voxel) {
            part.voxels[voxel] = site_.lumenAt(part.geometry.voxelAt(voxel)) != 0 ? 1 : 0;
        }
        const DistanceMap distances = distanceMap(part, 1, progress);
        site_.labels.voxels = labelWideBasins(distances, minNeckWithin);
        for (std::size_t voxel = 0; voxel < part.voxels.size(); ++voxel) {
            if (part.voxels[voxel] != 0) {
                double& radiusMm = radiusMm_[site_.labels.voxels[voxel]];
                radiusMm = std::max(radiusMm, distances.mm(voxel));
                front_.push_back(part.geometry.voxelAt(voxel));
            }
        }
    }

    /// Returns whether growth may continue: up to the brightest line of a strut, or between struts.
    bool canGrow(const Eigen::Vector3i& from, const Eigen::Vector3i& to) const
    {
        const double opacification = site_.fillAt(to);
        const bool isRising = site_.isStrut(to) && opacification > site_.fillAt(from);
        return opacification >= minFillBetweenStruts && (isRising || !site_.isStrut(from)) && site_.isBesideStruts(to);
    }

    /// Returns whether a voxel lies between different components; records their contact and whether it shows lumen.
    bool isBetweenComponents(const Eigen::Vector3i& at, Label label)
    {
        const bool isBlood = !site_.isStrut(at) && site_.fillAt(at) >= minLumenOpacification;
        std::map<Label, bool> others;   // whether lumen is visible in between
        site_.forEachLabeledNeighbor(at, [&](Label its, const Eigen::Vector3i& beside) {
            if (its != label) {
                others[its] = others[its] || (isBlood && !site_.isStrut(beside));
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

    std::map<Label, Label> groupIntoVessels() const
    {
        std::map<Label, Label> vessels;
        for (const auto& [label, radiusMm] : radiusMm_) {
            vessels[label] = label;
        }
        for (const auto& [pair, contact] : contacts_) {
            if (isSameVessel(pair, contact)) {
                const Label joined = vessels[pair.second];
                for (auto& [label, vessel] : vessels) {
                    vessel = vessel == joined ? vessels[pair.first] : vessel;
                }
            }
        }
        return vessels;
    }

    /// Returns whether two components are one lumen crossed by struts, or a vessel and a branch leaving between struts.
    bool isSameVessel(const Pair& pair, const Contact& contact) const
    {
        if (contact.open.empty() || !hasSameOpacification(pair, contact)) {
            return false;
        }
        const double openShare = static_cast<double>(contact.open.size()) / static_cast<double>(contact.places.size());
        const double thinnerMm = std::min(radiusMm_.at(pair.first), radiusMm_.at(pair.second));
        return openShare >= minOpenShare || spanMm(contact) <= maxOpeningInRadii * thinnerMm;
    }

    double spanMm(const Contact& contact) const
    {
        const VoxelBox box = contact.box();
        return site_.geometry().spacingMm.cwiseProduct((box.high - box.low).cast<double>()).norm();
    }

    /// Returns whether both components have the same opacification, or one is too thin to decide.
    bool hasSameOpacification(const Pair& pair, const Contact& contact) const
    {
        const VoxelBox box = contact.box();
        const Eigen::Vector3i reach = (besideOpeningMm / site_.geometry().spacingMm.array()).ceil().cast<int>();
        const VoxelBox around{box.low - reach, box.high + reach};
        const StentSite::OpacificationSamples first = site_.collectOpacification(pair.first, around);
        const StentSite::OpacificationSamples second = site_.collectOpacification(pair.second, around);
        if (first.inner.size() < minInnerOfLumen || second.inner.size() < minInnerOfLumen) {
            return std::min(quantile(first.all, 0.9), quantile(second.all, 0.9)) >= minLumenOpacification;
        }
        return std::abs(medianOf(first.inner) - medianOf(second.inner)) <= maxDifference;
    }

    StentSite site_;   ///< box around the stents, labeled with the components
    std::vector<Eigen::Vector3i> front_;   ///< most recently added voxels
    VoxelComponent added_;   ///< added voxels, as indices of the whole scan
    std::map<Label, double> radiusMm_;   ///< maximum radius of each component
    std::map<Pair, Contact> contacts_;   ///< by pair of adjacent components
};

}   // namespace

VoxelComponent growLumenBesideStruts(const VoxelMask& lumen, const StentStruts& wires,
                                     const VoxelOpacification& opacification, int steps, TracingProgress& progress)
{
    if (wires.pieces.empty()) {
        return {};
    }
    LumenGrowth growth(lumen, wires, opacification, progress);
    for (int n = 0; n < steps && progress.advance(0.0); ++n) {
        growth.advance();
    }
    if (!progress.isStopped()) {
        growth.fillGaps();
    }
    return std::move(growth).added();
}

}   // namespace angiopose::core
