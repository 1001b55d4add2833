#include "core/tracing/volume/component_report.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/component_selection.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double minReportedFraction = 0.02;   ///< minimum total fraction of all voxels
constexpr std::size_t maxListed = 6;   ///< maximum number of components per sentence

/// Returns the branch length per component; each step counts toward the component in which it ends.
std::vector<double> lengthsByComponent(const VoxelMask& lumen, const std::vector<VoxelComponent>& pieces,
                                       const VesselTree& tree)
{
    std::vector<double> lengths(pieces.size(), 0.0);
    const Eigen::Affine3d voxelFromPatient = lumen.geometry.patientFromVoxel().inverse();
    std::size_t last = 0;   // the next point is usually in the same component
    const auto componentContaining = [&](std::uint32_t voxel) {
        for (std::size_t n = 0; n < pieces.size(); ++n) {
            const std::size_t p = (last + n) % pieces.size();
            if (pieces[p].front() <= voxel && voxel <= pieces[p].back() &&
                std::binary_search(pieces[p].begin(), pieces[p].end(), voxel)) {
                return p;
            }
        }
        return pieces.size();
    };
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t n = 1; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3i at = (voxelFromPatient * branch.pointsInPatient[n]).array().round().cast<int>();
            const std::size_t piece =
                lumen.geometry.contains(at)
                    ? componentContaining(static_cast<std::uint32_t>(lumen.geometry.index(at.x(), at.y(), at.z())))
                    : pieces.size();
            if (piece < pieces.size()) {
                lengths[piece] += (branch.pointsInPatient[n] - branch.pointsInPatient[n - 1]).norm();
                last = piece;
            }
        }
    }
    return lengths;
}

Quantity toPercent(double share)
{
    return Quantity{100.0 * share, share < 0.01 ? 1 : 0, "%"};
}

enum class Reported { LengthAndShare, Share };

/// Lists the first components as "31 mm, 12 %, at (1.0, 2.0, 3.0)" and sums up the others.
Messages describeComponents(const std::vector<TracedComponent>& pieces, Reported reported)
{
    Messages descriptions;
    double otherFraction = 0.0;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        const Message place = formatPoint(pieces[n].positionInPatient);
        if (n + 1 > maxListed && pieces.size() > maxListed + 1) {
            otherFraction += pieces[n].share;
        } else if (reported == Reported::LengthAndShare) {
            descriptions.push_back(
                messages::componentOfLength(inMm(pieces[n].lengthMm, 0), toPercent(pieces[n].share), place));
        } else {
            descriptions.push_back(messages::componentOfShare(toPercent(pieces[n].share), place));
        }
    }
    if (pieces.size() > maxListed + 1) {
        descriptions.push_back(messages::otherComponents(pieces.size() - maxListed, toPercent(otherFraction)));
    }
    return descriptions;
}

double totalFraction(const std::vector<TracedComponent>& pieces)
{
    double share = 0.0;
    for (const TracedComponent& piece : pieces) {
        share += piece.share;
    }
    return share;
}

}   // namespace

std::vector<TracedComponent> listComponents(const VoxelMask& lumen, const VesselTree& tree,
                                            std::vector<TracedComponent> excluded, TracingProgress& progress)
{
    const std::vector<VoxelComponent> pieces = connectedComponents(lumen, 1, &progress);
    if (progress.isStopped() || pieces.empty()) {
        return {};
    }
    const std::vector<double> lengths = lengthsByComponent(lumen, pieces, tree);
    std::vector<TracedComponent> all = std::move(excluded);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        all.push_back(describeComponent(pieces[p], lumen.geometry));
        all.back().lengthMm = lengths[p];
        all.back().isRequested = true;
    }
    double voxels = 0.0;
    for (const TracedComponent& piece : all) {
        voxels += static_cast<double>(piece.voxels);
    }
    for (TracedComponent& piece : all) {
        piece.share = static_cast<double>(piece.voxels) / voxels;
    }
    std::ranges::stable_sort(all, std::greater(), &TracedComponent::voxels);
    return all;
}

Messages componentWarnings(const std::vector<TracedComponent>& pieces, bool isSelectedBySeeds)
{
    std::vector<TracedComponent> traced, notRequested, tooShort;
    for (const TracedComponent& piece : pieces) {
        (piece.isTraced() ? traced : piece.isRequested ? tooShort : notRequested).push_back(piece);
    }
    Messages reported;
    if (traced.size() > 1 && !isSelectedBySeeds) {
        reported.push_back(
            messages::vesselsInComponents(traced.size(), describeComponents(traced, Reported::LengthAndShare)));
    }
    if (totalFraction(notRequested) > minReportedFraction) {
        const Messages descriptions = describeComponents(notRequested, Reported::Share);
        reported.push_back(notRequested.size() == 1
                               ? messages::oneComponentLeftOut(descriptions)
                               : messages::componentsLeftOut(notRequested.size(),
                                                             toPercent(totalFraction(notRequested)), descriptions));
    }
    if (totalFraction(tooShort) > minReportedFraction) {
        const Messages descriptions = describeComponents(tooShort, Reported::Share);
        reported.push_back(
            tooShort.size() == 1
                ? messages::oneComponentTooShort(descriptions)
                : messages::componentsTooShort(tooShort.size(), toPercent(totalFraction(tooShort)), descriptions));
    }
    return reported;
}

}   // namespace angiopose::core
