#pragma once

#include "app/document/case_document.h"
#include "app/jobs/registration_job.h"
#include "app/registration/target_provider.h"

#include <QObject>

namespace angiopose::app {

/// Registers the open case: traces the vessels if needed, then runs the solver and shows the pose live. Stop keeps the
/// best pose so far. The result is one undo step.
class RegistrationController : public QObject {
    Q_OBJECT
public:
    RegistrationController(CaseDocument& document, TargetProvider& target, QObject* parent = nullptr);

    /// Returns the reason why the case cannot be registered yet; empty if it can be registered.
    QString notReadyReason() const;
    bool isRunning() const { return phase_ != Phase::Idle; }
    void start();
    void stop();   ///< returns at once
    void setAllViews(bool allViews) { registersAllViews_ = allViews; }   ///< whether to register all views jointly

signals:
    void runningChanged(bool running);
    void tracingStarted();
    void progressed(const app::RunReport& report);
    void finished(const core::RegistrationResult& result);
    void failed(const QString& reason);

private:
    enum class Phase { Idle, Tracing, Solving };
    void continueAfterTracing();
    void apply(const core::RegisteredCase& registered);
    void reportFailure(const core::Message& reason);
    void end();

    CaseDocument& document_;
    TargetProvider& target_;
    RegistrationJob job_;
    bool registersAllViews_ = true;
    bool stopRequested_ = false;
    Phase phase_ = Phase::Idle;
};

}   // namespace angiopose::app
