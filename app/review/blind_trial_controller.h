#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "app/jobs/judge_job.h"
#include "app/registration/target_provider.h"
#include "io/observer_log.h"
#include "ui/dialogs/blind_trial_dialog.h"

#include <QElapsedTimer>
#include <QObject>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Observer studies: the vessels start at random, whatever could tell how good a pose is stays out of sight, and time
/// and pose are logged. The case itself comes back unchanged, with the observer's pose among the snapshots.
class BlindTrialController : public QObject {
    Q_OBJECT
public:
    BlindTrialController(CaseDocument& document, TargetProvider& target, ui::MainWindow& window,
                         QObject* parent = nullptr);

    void ask();
    void start(const ui::BlindTrialSetup& setup);
    void finish();
    void abandon();
    bool isRunning() const { return document_.isInTrial(); }

signals:
    void aboutToStart();   ///< the last moment at which all is in sight, and in the document
    void started();
    void ended();
    void logged(const QString& path);
    void failed(const QString& reason);

private:
    void end(bool isAbandoned);
    void showRunning(bool running);
    void log(const io::ObserverTrial& trial);
    void judge(const io::ObserverTrial& trial);
    void keep(const core::RegistrationResult& judged);

    CaseDocument& document_;
    TargetProvider& target_;
    ui::MainWindow& window_;
    ui::BlindTrialSetup setup_;
    io::ObserverTrial trial_;
    int caseNumber_ = 0;
    QElapsedTimer clock_;
    JudgeJob judge_;
    FileQueue files_;
};

}   // namespace angiopose::app