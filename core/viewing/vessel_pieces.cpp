#include "core/viewing/vessel_pieces.h"

#include "core/messages/says.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double pieceLengthMm = 1.0;

void addPieces(const VesselBranch& branch, std::vector<VesselPiece>& pieces)
{
    for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d& from = branch.pointsInPatient[i - 1];
        const Eigen::Vector3d& to = branch.pointsInPatient[i];
        const double radiusMm =
            branch.radiusMm.empty() ? assumedRadiusMm : 0.5 * (branch.radiusMm[i - 1] + branch.radiusMm[i]);
        pieces.push_back({0.5 * (from + to), to - from, radiusMm, branch.id});
    }
}

const VesselNode* takeOffOf(const VesselBranch& branch, const std::vector<VesselNode>& nodes)
{
    const VesselNode* nearest = nullptr;
    double leastMm = std::numeric_limits<double>::infinity();
    for (const VesselNode& node : nodes) {
        const double distanceMm = (node.pointInPatient - branch.pointsInPatient.front()).norm();
        if (node.isBifurcation() && std::ranges::count(node.branchIds, branch.id) > 0 && distanceMm < leastMm) {
            nearest = &node;
            leastMm = distanceMm;
        }
    }
    return nearest;
}

}   // namespace

std::vector<VesselPiece> vesselPiecesOf(const VesselTree& tree)
{
    std::vector<VesselPiece> pieces;
    for (const VesselBranch& branch : resampled(tree, pieceLengthMm).branches) {
        addPieces(branch, pieces);
    }
    return pieces;
}

std::vector<VesselPiece> piecesOfBranch(const std::vector<VesselPiece>& pieces, int branchId)
{
    std::vector<VesselPiece> found;
    std::ranges::copy_if(pieces, std::back_inserter(found),
                         [branchId](const VesselPiece& piece) { return piece.branchId == branchId; });
    return found;
}

Result<std::vector<VesselPiece>> piecesOfTakeOff(const VesselTree& tree, int branchId, double reachMm)
{
    const VesselBranch* branch = tree.find(branchId);
    if (!branch) {
        return Error(says::noSuchBranch(branchId));
    }
    const std::vector<VesselNode> nodes = findNodes(resampled(tree, pieceLengthMm));
    const VesselNode* takeOff = takeOffOf(*branch, nodes);
    if (!takeOff) {
        return Error(says::noTakeOff(branchId));
    }
    std::vector<VesselPiece> found;
    for (const VesselPiece& piece : vesselPiecesOf(tree)) {
        const bool meetsThere = std::ranges::count(takeOff->branchIds, piece.branchId) > 0;
        if (meetsThere && (piece.middleInPatient - takeOff->pointInPatient).norm() <= reachMm) {
            found.push_back(piece);
        }
    }
    return found;
}

}   // namespace angiopose::core
