#pragma once

#include "core/imaging/angiogram.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <deque>
#include <memory>

namespace angiopose::app {

/// Caches treated versions of the open run. The newest are kept, so switching between them is instant; older ones are
/// found while another owner (the undo history) holds them, so the same images never exist twice in memory.
class TreatedRuns {
public:
    using SharedRun = std::shared_ptr<const core::Angiogram>;

    void remember(const SharedRun& stored, const core::RunTreatment& treatment, const SharedRun& run);
    SharedRun find(const SharedRun& stored, const core::RunTreatment& treatment) const;   ///< null: no longer available
    void forgetAllBut(const SharedRun& stored);   ///< call when another case is opened

private:
    struct Made {
        std::weak_ptr<const core::Angiogram> stored;
        core::RunTreatment treatment;
        std::weak_ptr<const core::Angiogram> run;
    };
    std::deque<Made> made_;   ///< newest last
    std::deque<SharedRun> kept_;
};

}   // namespace angiopose::app