#include "core/registration/judging/unopacified_branches.h"

#include "core/messages/messages.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double mainlyUnopacified = 0.5;
constexpr std::size_t namedBranches = 8;

}   // namespace

std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView)
{
    std::vector<double> seen(tree.branchIds.size(), 0.0);
    std::vector<double> empty(tree.branchIds.size(), 0.0);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const auto branch = static_cast<std::size_t>(tree.branchIndex[i]);
        seen[branch] += isInView[i] != 0 ? 1.0 : 0.0;
        empty[branch] += isInView[i] != 0 && isOpacified[i] == 0 ? 1.0 : 0.0;
    }
    std::vector<UnopacifiedBranch> unopacified;
    for (std::size_t branch = 0; branch < seen.size(); ++branch) {
        if (empty[branch] > mainlyUnopacified * seen[branch]) {
            unopacified.push_back({tree.branchIds[branch], empty[branch] / seen[branch]});
        }
    }
    return unopacified;
}

double opacifiedLengthFraction(const std::vector<std::uint8_t>& isOpacified)
{
    const auto filled = std::ranges::count(isOpacified, std::uint8_t{1});
    return static_cast<double>(filled) / static_cast<double>(std::max<std::size_t>(1, isOpacified.size()));
}

double assessedFraction(const RegistrationResult& result)
{
    for (const Message& said : result.warnings) {
        const bool shows = said.is(messages::treePartlyOpacified) || said.is(messages::fewBranchesOpacified) ||
                           said.is(messages::onlySegmentsOpacified);
        const Quantity* const percent = shows ? std::get_if<Quantity>(&said.arguments().front()) : nullptr;
        if (percent) {
            return 0.01 * percent->value;
        }
    }
    double all = 0.0, filled = 0.0;   // fallback for results whose messages were stored by another version
    for (const BranchResidual& branch : result.branches) {
        const bool isEmpty = std::ranges::find(result.unopacified, branch.branchId, &UnopacifiedBranch::branchId) !=
                             result.unopacified.end();
        all += branch.pointCount;
        filled += isEmpty ? 0.0 : branch.pointCount;
    }
    return all > 0.0 ? filled / all : 1.0;
}

Messages unopacifiedMessages(const std::vector<UnopacifiedBranch>& unopacified, double opacifiedFraction,
                             std::size_t branchCount)
{
    const Quantity shown{100.0 * opacifiedFraction, 0, "%"};
    if (unopacified.empty()) {
        return {};
    }
    if (unopacified.size() == branchCount) {
        return {messages::onlySegmentsOpacified(shown)};
    }
    if (unopacified.size() > namedBranches) {
        return {messages::fewBranchesOpacified(shown, unopacified.size(), branchCount)};
    }
    std::vector<std::string> names;
    for (const UnopacifiedBranch& branch : unopacified) {
        names.push_back(std::to_string(branch.branchId));
    }
    return {messages::treePartlyOpacified(shown, names)};
}

}   // namespace angiopose::core
