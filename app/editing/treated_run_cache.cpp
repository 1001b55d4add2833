#include "app/editing/treated_run_cache.h"

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr std::size_t keptRuns = 3;

}   // namespace

void TreatedRunCache::remember(const SharedRun& stored, const core::RunProcessing& processing, const SharedRun& run)
{
    std::erase_if(entries_, [](const Entry& made) { return made.run.expired(); });
    entries_.push_back({stored, processing, run});
    recentRuns_.push_back(run);
    if (recentRuns_.size() > keptRuns) {
        recentRuns_.pop_front();
    }
}

TreatedRunCache::SharedRun TreatedRunCache::find(const SharedRun& stored, const core::RunProcessing& processing) const
{
    const auto known = std::ranges::find_if(
        entries_, [&](const Entry& made) { return made.stored.lock() == stored && made.processing == processing; });
    return known == entries_.end() ? nullptr : known->run.lock();
}

void TreatedRunCache::retainOnly(const SharedRun& stored)
{
    const auto before = entries_.size();
    // If no run is open, discards everything: an expired run would compare equal to the null pointer `stored`.
    std::erase_if(entries_, [&stored](const Entry& made) { return !stored || made.stored.lock() != stored; });
    if (entries_.size() != before) {
        recentRuns_.clear();
    }
}

}   // namespace angiopose::app
