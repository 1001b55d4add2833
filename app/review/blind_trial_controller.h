#pragma once

#include "app/document/case_document.h"
#include "app/jobs/evaluation_job.h"
#include "app/jobs/file_queue.h"
#include "app/registration/target_provider.h"
#include "io/observer_log.h"
#include "ui/dialogs/blind_trial_dialog.h"

#include <QElapsedTimer>
#include <QObject>

#include <vector>

class QWidget;

namespace angiopose::ui {
class TrialBar;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Conducts observer studies: the vessels start at a random pose, everything that could reveal how good a pose is stays
/// hidden, and time and pose are logged. Afterward, the case is unchanged except for a snapshot of the observer's pose.
class BlindTrialController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TrialBar& bar;
        std::vector<QWidget*> verdictWidgets;   ///< widgets that show how good a pose is; hidden during a trial
        QWidget& dialogParent;
    };
    BlindTrialController(CaseDocument& document, TargetProvider& target, const Ui& ui, QObject* parent = nullptr);

    void openDialog();
    void start(const ui::BlindTrialSetup& setup);
    void finish();
    void abandon();
    bool isRunning() const { return document_.isInTrial(); }

signals:
    void aboutToStart();   ///< emitted while everything is still visible and the document is unchanged
    void started();
    void ended();
    void logged(const QString& path);
    void failed(const QString& reason);

private:
    void end(bool isAbandoned);
    void showRunning(bool running);
    void log(const io::ObserverTrial& trial);
    void evaluate(const io::ObserverTrial& trial);
    void addSnapshot(const core::RegistrationResult& evaluated);

    CaseDocument& document_;
    TargetProvider& target_;
    Ui ui_;
    ui::BlindTrialSetup setup_;
    io::ObserverTrial trial_;
    int caseNumber_ = 0;
    QElapsedTimer clock_;
    EvaluationJob evaluationJob_;
    FileQueue files_;
};

}   // namespace angiopose::app
