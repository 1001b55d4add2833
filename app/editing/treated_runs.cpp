#include "app/editing/treated_runs.h"

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr std::size_t keptRuns = 3;

}   // namespace

void TreatedRuns::remember(const SharedRun& stored, const core::RunTreatment& treatment, const SharedRun& run)
{
    std::erase_if(made_, [](const Made& made) { return made.run.expired(); });
    made_.push_back({stored, treatment, run});
    kept_.push_back(run);
    if (kept_.size() > keptRuns) {
        kept_.pop_front();
    }
}

TreatedRuns::SharedRun TreatedRuns::find(const SharedRun& stored, const core::RunTreatment& treatment) const
{
    const auto known = std::ranges::find_if(
        made_, [&](const Made& made) { return made.stored.lock() == stored && made.treatment == treatment; });
    return known == made_.end() ? nullptr : known->run.lock();
}

void TreatedRuns::forgetAllBut(const SharedRun& stored)
{
    const auto before = made_.size();
    // If no run is open, everything is discarded: an expired run would compare equal to the null pointer `stored`.
    std::erase_if(made_, [&stored](const Made& made) { return !stored || made.stored.lock() != stored; });
    if (made_.size() != before) {
        kept_.clear();
    }
}

}   // namespace angiopose::app
