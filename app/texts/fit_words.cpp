#include "app/texts/fit_words.h"

#include "app/messages/says_report.h"
#include "app/texts/number_text.h"

namespace angiopose::app {
namespace {

std::string nameOf(const core::VesselTree& tree, int branchId)
{
    const core::VesselBranch* branch = tree.find(branchId);
    return branch && !branch->name.empty() ? branch->name : std::to_string(branchId);
}

}   // namespace

core::Messages fitWords(const core::FitBasis& basis, const core::Vessels& vessels)
{
    core::Messages words;
    const core::Quantity median = core::inMm(basis.wholeMedianMm, 2), p95 = core::inMm(basis.wholeP95Mm, 2);
    if (basis.judgedShare < 1.0) {
        words.push_back(says::overOpacified(core::Quantity{100.0 * basis.judgedShare, 0, "%"}, median, p95));
    }
    std::vector<std::string> names;
    for (const auto& [branchId, medianMm] : basis.excludedMm) {
        names.push_back(nameOf(*vessels.tree, branchId) + ": " + fixedText(medianMm, 1) + " mm");
    }
    if (!names.empty()) {
        words.push_back(says::withoutExcluded(names, median, p95));
    }
    names.clear();
    for (const int branchId : vessels.auxiliaryBranchIds) {
        names.push_back(nameOf(*vessels.tree, branchId));
    }
    if (!names.empty()) {
        words.push_back(says::auxiliaryOf(names));
    }
    return words;
}

}   // namespace angiopose::app
