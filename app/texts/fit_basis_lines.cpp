#include "app/texts/fit_basis_lines.h"

#include "app/messages/messages.h"
#include "app/texts/number_text.h"

namespace angiopose::app {
namespace {

std::vector<std::string> namedMedians(const core::VesselTree& tree,
                                      const std::vector<std::pair<int, double>>& mediansMm)
{
    std::vector<std::string> words;
    for (const auto& [branchId, medianMm] : mediansMm) {
        const core::VesselBranch* branch = tree.find(branchId);
        words.push_back((branch && !branch->name.empty() ? branch->name : std::to_string(branchId)) + ": " +
                        fixedText(medianMm, 1) + " mm");
    }
    return words;
}

}   // namespace

core::Messages fitBasisLines(const core::FitBasis& basis, const core::Vessels& vessels)
{
    core::Messages words;
    const core::Quantity median = core::inMm(basis.wholeMedianMm, 2), p95 = core::inMm(basis.wholeP95Mm, 2);
    if (basis.assessedFraction < 1.0) {
        words.push_back(messages::overOpacified(core::Quantity{100.0 * basis.assessedFraction, 0, "%"}, median, p95));
    }
    if (!basis.excludedMm.empty()) {
        words.push_back(messages::withoutExcluded(namedMedians(*vessels.tree, basis.excludedMm), median, p95));
    }
    if (!basis.auxiliaryMm.empty()) {
        words.push_back(messages::auxiliaryOf(namedMedians(*vessels.tree, basis.auxiliaryMm)));
    }
    return words;
}

}   // namespace angiopose::app
