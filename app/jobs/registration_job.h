#pragma once

#include "app/jobs/job.h"
#include "core/workflow/register_case.h"

#include <QObject>

namespace angiopose::app {

/// Progress of a running registration, for display.
struct RunReport {
    core::IterationReport iteration;   ///< report of the solver; its progress refers to the whole registration
    bool isOfShownView = true;   ///< true if the pose belongs to the shown view
};

/// Runs core::registerCase on the open case off the GUI thread.
class RegistrationJob : public QObject {
    Q_OBJECT
public:
    explicit RegistrationJob(QObject* parent = nullptr);

    void start(core::Case session, core::RegistrationPlan plan);
    void requestStop() { job_.requestStop(); }   ///< returns at once; the job then emits `finished` or `failed`
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(const app::RunReport& report);   ///< emitted at most 30 times per second
    void finished(const core::RegisteredCase& registered);   ///< after a stop, `registered` holds the best poses so far
    void failed(const core::Message& reason);

private:
    Job<core::RegisteredCase, RunReport> job_;
};

}   // namespace angiopose::app
