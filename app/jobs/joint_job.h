#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"
#include "core/support/result.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <vector>

namespace angiopose::app {

/// Registers all views of a case together off the GUI thread; the other views' vessels are traced first. Every signal
/// arrives on the job's own thread.
class JointJob : public QObject {
    Q_OBJECT
public:
    explicit JointJob(QObject* parent = nullptr);
    ~JointJob() override;   ///< stops and waits, for one solver iteration or one frame's tracing at most

    /// Registers core::registeredViews(theCase); `target`: of the shown one.
    void start(core::Case theCase, core::Centerline2d target);
    void requestStop() { stopRequested_ = true; }   ///< returns at once; `finished` or `failed` follows

signals:
    void advanced(const core::IterationReport& report);   ///< of the first view, at most thirty times a second
    void finished(const core::MultiViewResult& result);   ///< after a stop: best poses so far
    void failed(const core::Message& reason);

private:
    using Outcome = core::Result<core::MultiViewResult>;
    Outcome solve(const core::Case& theCase, core::Centerline2d target);
    void publish();

    std::atomic<bool> stopRequested_{false};
    QFutureWatcher<Outcome> watcher_;
};

}   // namespace angiopose::app