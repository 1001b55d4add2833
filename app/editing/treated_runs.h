#pragma once

#include "core/imaging/angiogram.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <deque>
#include <memory>

namespace angiopose::app {

/// What was made of the open run: the newest are kept, so that switching to and fro costs nothing; older ones are found
/// as long as somebody else keeps them (the history of undo), so that the same picture never lies in memory twice.
class TreatedRuns {
public:
    using SharedRun = std::shared_ptr<const core::Angiogram>;

    void remember(const SharedRun& stored, const core::RunTreatment& treatment, const SharedRun& run);
    SharedRun find(const SharedRun& stored, const core::RunTreatment& treatment) const;   ///< null: not there any more
    void forgetAllBut(const SharedRun& stored);   ///< another case was opened

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