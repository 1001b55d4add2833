#include "core/case/case_patients.h"

#include "core/imaging/patient_match.h"

#include <algorithm>

namespace angiopose::core {

Messages findMismatch(const Case& theCase)
{
    Messages found;
    const auto compare = [&found](const StudyIdentity& one, const StudyIdentity& other, Compared compared) {
        for (const Message& mismatch : findMismatch(one, other, compared)) {
            if (std::ranges::find(found, mismatch) == found.end()) {
                found.push_back(mismatch);
            }
        }
    };
    for (std::size_t k = 0; k < theCase.views.size(); ++k) {
        const auto& run = theCase.views[k].angiogram;
        if (!run) {
            continue;
        }
        compare(theCase.vessels.scanIdentity, run->identity, Compared::ScanAndRun);
        for (std::size_t before = 0; before < k; ++before) {
            if (const auto& other = theCase.views[before].angiogram) {
                compare(other->identity, run->identity, Compared::TwoRuns);
            }
        }
    }
    return found;
}

}   // namespace angiopose::core
