#pragma once

#include "app/jobs/trace_job.h"
#include "core/case/case.h"

#include <QObject>

#include <deque>
#include <memory>
#include <optional>

namespace angiopose::app {

/// The traced vessels of the case's frame: the given 2-D centreline, or tracing on a worker, remembered per frame and
/// options. Only the newest wish is answered.
class TargetProvider : public QObject {
    Q_OBJECT
public:
    explicit TargetProvider(QObject* parent = nullptr);

    void want(const core::Case& session);
    const SharedCenterline& current() const { return current_; }   ///< null until ready
    const SharedTrace& trace() const { return trace_; }   ///< null while the target is a given one, or not ready
    const std::optional<core::Message>& problem() const { return problem_; }   ///< why there is none
    bool isTracing() const { return job_.isRunning(); }

signals:
    void changed();   ///< `current` or `problem`

private:
    struct Remembered {
        std::weak_ptr<const core::Angiogram> run;   ///< kept alive by the case and its history only
        int frame = 0;
        core::TraceOptions options;
        SharedTrace trace;
    };

    void startWanted();
    SharedTrace known(const TraceRequest& request);
    void remember(const TraceRequest& asked, const SharedTrace& traced);
    void settle(const SharedTrace& trace, const std::optional<core::Message>& problem);
    void settleGiven(const SharedCenterline& given);
    void settle(const SharedCenterline& target, const SharedTrace& trace, const std::optional<core::Message>& problem);

    TraceJob job_;
    std::optional<TraceRequest> wanted_;
    std::optional<TraceRequest> asked_;   ///< what is being traced
    std::deque<Remembered> traced_;   ///< newest last
    SharedCenterline current_;
    SharedTrace trace_;
    std::optional<core::Message> problem_;
};

}   // namespace angiopose::app