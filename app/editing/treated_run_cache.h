#pragma once

#include "core/imaging/angiogram.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <deque>
#include <memory>

namespace angiopose::app {

/// Caches processed versions of the open run. The newest ones stay in memory, so switching between them is instant.
/// Older ones are found as long as another owner (the undo history) holds them, so that no images are in memory twice.
class TreatedRunCache {
public:
    using SharedRun = std::shared_ptr<const core::Angiogram>;

    void remember(const SharedRun& stored, const core::RunProcessing& processing, const SharedRun& run);
    SharedRun find(const SharedRun& stored,
                   const core::RunProcessing& processing) const;   ///< null if no longer available
    void retainOnly(const SharedRun& stored);   ///< call when another case has been opened

private:
    struct Entry {
        std::weak_ptr<const core::Angiogram> stored;
        core::RunProcessing processing;
        std::weak_ptr<const core::Angiogram> run;
    };
    std::deque<Entry> entries_;   ///< known versions, newest last
    std::deque<SharedRun> recentRuns_;
};

}   // namespace angiopose::app
