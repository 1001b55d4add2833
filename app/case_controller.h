#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "app/editing/pose_controller.h"
#include "app/files/export_controller.h"
#include "app/files/open_controller.h"
#include "app/files/save_controller.h"
#include "app/jobs/file_queue.h"
#include "app/jobs/judge_job.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/review/look_controller.h"
#include "app/review/replay_controller.h"
#include "app/review/review_controller.h"
#include "app/review/view_sync.h"
#include "ui/main_window.h"

#include <QTimer>

namespace app {

/// Connects the window with the document and the jobs; each sub-controller holds one of the user's intents.
class CaseController : public QObject {
    Q_OBJECT
public:
    explicit CaseController(ui::MainWindow& window, QObject* parent = nullptr);

    /// Notice, recovery offer and the files of the command line.
    void begin(const QStringList& paths);
    void open(const QStringList& paths) { open_.open(paths); }
    bool isLoading() const { return open_.isLoading(); }

    CaseDocument& document() { return document_; }
    SaveController& saving() { return save_; }
    ExportController& exporting() { return export_; }
    RegistrationController& registration() { return registration_; }
    PoseController& pose() { return pose_; }
    BranchController& branches() { return branches_; }
    TargetProvider& target() { return target_; }
    const SharedJudgement& judgement() const { return judgement_; }

private:
    void connectFiles();
    void connectEditing();
    void connectBranches();
    void connectPose();
    void connectReview();
    void connectGeometry();
    void connectRegistration();
    void connectHelp();
    void followDocument();
    void followTarget();
    void judge(const core::RigidTransform& cameraFromPatient);
    void showJudgement();
    bool isMovedFromStart() const;
    void showProgress(const core::IterationReport& report);
    void showFinished(const core::RegistrationResult& result);
    void setRunning(bool running);
    void showTitle();
    void showSteps();
    void showGeometry();
    void showNote(const QString& note);   ///< in the strip, for a while
    void showProblem(const QString& heading, const QString& reason, const QStringList& paths = {});
    void showNotice();
    void fillRecent();
    void askFiles();
    void openSample();
    void askToReplace();
    void requestClose();
    void answerClose(int index);
    void closeWindow();

    ui::MainWindow& window_;
    CaseDocument document_;
    TargetProvider target_;
    ViewSync sync_;
    BranchController branches_;
    PoseController pose_;
    RegistrationController registration_;
    OpenController open_;
    SaveController save_;
    ExportController export_;
    ReviewController review_;
    LookController look_;
    ReplayController replay_;
    JudgeJob judge_;
    SharedJudgement judgement_;
    FileQueue files_;   ///< makes the sample case
    QTimer noteTimer_;
    QTimer clock_;   ///< keeps "Autosaved 12 s ago" true
    enum class Closing { No, Now, AfterSaving };
    Closing closing_ = Closing::No;
    bool recovering_ = false;
    bool exported_ = false;
};

}   // namespace app
