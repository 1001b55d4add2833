#pragma once

#include "app/jobs/job.h"
#include "core/workflow/register_case.h"

#include <QObject>

namespace angiopose::app {

/// Progress of a running registration, for display.
struct RunReport {
    core::IterationReport iteration;   ///< of the solver; its progress is that of the whole registration
    bool isOfShownView = true;   ///< whether the pose belongs to the shown view
};

/// Registers the open case off the GUI thread: core::registerCase.
class RegistrationJob : public QObject {
    Q_OBJECT
public:
    explicit RegistrationJob(QObject* parent = nullptr);

    void start(core::Case session, core::RegistrationPlan plan);
    void requestStop() { job_.requestStop(); }   ///< returns at once; `finished` or `failed` follows
    bool isRunning() const { return job_.isRunning(); }

signals:
    void advanced(const app::RunReport& report);   ///< at most thirty times a second
    void finished(const core::RegisteredCase& registered);   ///< after a stop: with the best poses so far
    void failed(const core::Message& reason);

private:
    Job<core::RegisteredCase, RunReport> job_;
};

}   // namespace angiopose::app
