#pragma once

#include "core/imaging/angiogram.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <deque>
#include <memory>

namespace angiopose::app {

/// Caches treated versions of the open run. The newest ones stay in memory, so switching between them is instant. Older
/// ones are found as long as another owner (the undo history) holds them, so the same images are never in memory twice.
class TreatedRuns {
public:
    using SharedRun = std::shared_ptr<const core::Angiogram>;

    void remember(const SharedRun& stored, const core::RunTreatment& treatment, const SharedRun& run);
    SharedRun find(const SharedRun& stored, const core::RunTreatment& treatment) const;   ///< null: no longer available
    void forgetAllBut(const SharedRun& stored);   ///< call when another case has been opened

private:
    struct Made {
        std::weak_ptr<const core::Angiogram> stored;
        core::RunTreatment treatment;
        std::weak_ptr<const core::Angiogram> run;
    };
    std::deque<Made> made_;   ///< known versions, newest last
    std::deque<SharedRun> kept_;
};

}   // namespace angiopose::app
