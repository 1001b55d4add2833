#include "core/tracing/volume/piece_report.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double worthMentioning = 0.02;   ///< minimum total fraction of all voxels
constexpr std::size_t maxNamed = 6;   ///< components per sentence

/// Sums the branch length per component; each step counts toward the component in which it ends.
std::vector<double> lengthsIn(const VoxelMask& lumen, const std::vector<VoxelPiece>& pieces, const VesselTree& tree)
{
    std::vector<double> lengths(pieces.size(), 0.0);
    const Eigen::Affine3d voxelFromPatient = lumen.geometry.patientFromVoxel().inverse();
    std::size_t last = 0;   // the next point is usually in the same component
    const auto pieceWith = [&](std::uint32_t voxel) {
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
                    ? pieceWith(static_cast<std::uint32_t>(lumen.geometry.index(at.x(), at.y(), at.z())))
                    : pieces.size();
            if (piece < pieces.size()) {
                lengths[piece] += (branch.pointsInPatient[n] - branch.pointsInPatient[n - 1]).norm();
                last = piece;
            }
        }
    }
    return lengths;
}

Quantity shareOf(double share)
{
    return Quantity{100.0 * share, share < 0.01 ? 1 : 0, "%"};
}

enum class Reported { LengthAndShare, Share };

/// Lists the first components as "31 mm, 12 %, at (1.0, 2.0, 3.0)" and sums up the others.
Messages namedPieces(const std::vector<TracedPiece>& pieces, Reported reported)
{
    Messages named;
    double rest = 0.0;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        const Message place = placeInMessage(pieces[n].placeInPatient);
        if (n + 1 > maxNamed && pieces.size() > maxNamed + 1) {
            rest += pieces[n].share;
        } else if (reported == Reported::LengthAndShare) {
            named.push_back(messages::pieceOfLength(inMm(pieces[n].lengthMm, 0), shareOf(pieces[n].share), place));
        } else {
            named.push_back(messages::pieceOfShare(shareOf(pieces[n].share), place));
        }
    }
    if (pieces.size() > maxNamed + 1) {
        named.push_back(messages::otherPieces(pieces.size() - maxNamed, shareOf(rest)));
    }
    return named;
}

double shareOfAll(const std::vector<TracedPiece>& pieces)
{
    double share = 0.0;
    for (const TracedPiece& piece : pieces) {
        share += piece.share;
    }
    return share;
}

}   // namespace

std::vector<TracedPiece> reportedPieces(const VoxelMask& lumen, const VesselTree& tree,
                                        std::vector<TracedPiece> leftOut, TracingProgress& progress)
{
    const std::vector<VoxelPiece> pieces = piecesOf(lumen, 1, &progress);
    if (progress.isStopped() || pieces.empty()) {
        return {};
    }
    const std::vector<double> lengths = lengthsIn(lumen, pieces, tree);
    std::vector<TracedPiece> all = std::move(leftOut);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        all.push_back(pieceOf(pieces[p], lumen.geometry));
        all.back().lengthMm = lengths[p];
        all.back().isAskedFor = true;
    }
    double voxels = 0.0;
    for (const TracedPiece& piece : all) {
        voxels += static_cast<double>(piece.voxels);
    }
    for (TracedPiece& piece : all) {
        piece.share = static_cast<double>(piece.voxels) / voxels;
    }
    std::ranges::stable_sort(all, std::greater(), &TracedPiece::voxels);
    return all;
}

Messages pieceWarnings(const std::vector<TracedPiece>& pieces, bool isBySeeds)
{
    std::vector<TracedPiece> traced, unasked, tooShort;
    for (const TracedPiece& piece : pieces) {
        (piece.isTraced() ? traced : piece.isAskedFor ? tooShort : unasked).push_back(piece);
    }
    Messages reported;
    if (traced.size() > 1 && !isBySeeds) {
        reported.push_back(messages::vesselsInPieces(traced.size(), namedPieces(traced, Reported::LengthAndShare)));
    }
    if (shareOfAll(unasked) > worthMentioning) {
        const Messages named = namedPieces(unasked, Reported::Share);
        reported.push_back(unasked.size() == 1
                               ? messages::onePieceLeftOut(named)
                               : messages::piecesLeftOut(unasked.size(), shareOf(shareOfAll(unasked)), named));
    }
    if (shareOfAll(tooShort) > worthMentioning) {
        const Messages named = namedPieces(tooShort, Reported::Share);
        reported.push_back(tooShort.size() == 1
                               ? messages::onePieceTooShort(named)
                               : messages::piecesTooShort(tooShort.size(), shareOf(shareOfAll(tooShort)), named));
    }
    return reported;
}

}   // namespace angiopose::core
