#include "core/registration/alignment/opacification_model.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

std::size_t at(int number)
{
    return static_cast<std::size_t>(number);
}

}   // namespace

OpacificationModel::OpacificationModel(const TreeSamples& tree)
    : segments_(splitAtBifurcations(tree)), segmentOfPoint_(tree.size(), 0)
{
    const std::size_t pieceCount = segments_.pieces.size();
    for (std::size_t p = 0; p < pieceCount; ++p) {
        const BranchSegment& piece = segments_.pieces[p];
        double lengthMm = 0.0;
        for (std::size_t i = piece.from; i < piece.to; ++i) {
            segmentOfPoint_[i] = static_cast<int>(p);
            lengthMm += i > piece.from ? (tree.points[i] - tree.points[i - 1]).norm() : 0.0;
        }
        lengthMm_.push_back(lengthMm);
    }
    std::vector<std::vector<int>> neighbors(pieceCount + at(segments_.junctionCount));
    for (const SegmentIncidence& joint : segments_.incidences) {
        const int junction = static_cast<int>(pieceCount) + joint.junction;
        neighbors[at(joint.piece)].push_back(junction);
        neighbors[at(junction)].push_back(joint.piece);
    }
    std::vector<std::uint8_t> isListed(neighbors.size(), 0);
    for (std::size_t root = 0; root < neighbors.size(); ++root) {
        if (isListed[root] != 0) {
            continue;
        }
        std::size_t next = nodes_.size();
        nodes_.push_back({static_cast<int>(root), -1});
        isListed[root] = 1;
        for (; next < nodes_.size(); ++next) {
            const int here = nodes_[next].number;
            for (const int neighbor : neighbors[at(here)]) {
                if (isListed[at(neighbor)] == 0) {
                    isListed[at(neighbor)] = 1;
                    nodes_.push_back({neighbor, here});
                }
            }
        }
    }
}

std::vector<std::uint8_t> OpacificationModel::likeliestStates(std::span<const double> opacifiedGain,
                                                              double changeCost) const
{
    std::vector<std::array<double, 2>> gain(nodes_.size(),
                                            {0.0, 0.0});   // gain of the node and its subtree: unopacified, opacified
    for (std::size_t p = 0; p < opacifiedGain.size(); ++p) {
        gain[p][1] = opacifiedGain[p];
    }
    const auto bestBelow = [&](int node, std::size_t above) {
        return std::max(gain[at(node)][above], gain[at(node)][1 - above] - changeCost);
    };
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        for (const std::size_t above : {0U, 1U}) {
            if (node->above >= 0) {
                gain[at(node->above)][above] += bestBelow(node->number, above);
            }
        }
    }
    std::vector<std::uint8_t> state(nodes_.size(), 0);
    for (const Node& node : nodes_) {
        const std::array<double, 2>& own = gain[at(node.number)];
        const double bias = node.above < 0 ? 0.0 : state[at(node.above)] != 0 ? changeCost : -changeCost;
        state[at(node.number)] = own[1] - own[0] + bias > 0.0;
    }
    state.resize(opacifiedGain.size());
    return state;
}

int OpacificationModel::countOpacifiedBifurcations(std::span<const std::uint8_t> isOpacified) const
{
    std::vector<int> filled(at(segments_.junctionCount), 0);
    for (const SegmentIncidence& joint : segments_.incidences) {
        filled[at(joint.junction)] += isOpacified[at(joint.piece)] != 0 ? 1 : 0;
    }
    return static_cast<int>(std::ranges::count_if(filled, [](int pieces) { return pieces >= 3; }));
}

int OpacificationModel::countUnopacifiedTerritories(std::span<const std::uint8_t> isOpacified, double minMm) const
{
    const std::size_t pieceCount = segments_.pieces.size();
    std::vector<double> unopacifiedMm(nodes_.size(),
                                      0.0);   // length of a stretch that is not attached to an unopacified one
    std::vector<int> top(nodes_.size());
    for (const Node& node : nodes_) {
        const bool isPiece = at(node.number) < pieceCount;
        const bool isUnopacified = !isPiece || isOpacified[at(node.number)] == 0;
        // An opacified segment separates the unopacified parts on either side.
        const bool continues =
            node.above >= 0 && isUnopacified && (at(node.above) >= pieceCount || isOpacified[at(node.above)] == 0);
        top[at(node.number)] = continues ? top[at(node.above)] : node.number;
        unopacifiedMm[at(top[at(node.number)])] += isPiece && isUnopacified ? lengthMm_[at(node.number)] : 0.0;
    }
    return static_cast<int>(std::ranges::count_if(unopacifiedMm, [&](double mm) { return mm >= minMm; }));
}

}   // namespace angiopose::core
