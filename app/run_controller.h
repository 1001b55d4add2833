#pragma once

#include "app/document/case_document.h"
#include "app/files/session_controller.h"
#include "app/registration/registration_controller.h"
#include "app/review/judgement_controller.h"
#include "app/showing/notices.h"
#include "app/showing/review_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

namespace angiopose::ui {
class BottomStrip;
class GeometryPanel;
class PosePanel;
class RegistrationPanel;
class ResultPanel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Register and Stop, the method's options, and what the window shows while a registration runs and when it ends.
class RunController : public QObject {
    Q_OBJECT
public:
    /// What runs, and who shows it.
    struct Parts {
        CaseDocument& document;
        RegistrationController& registration;
        SessionController& session;
        ReviewController& review;
        JudgementController& judgement;
        ViewSync& sync;
        PosePreview& preview;
        Notices& notices;
        ui::WindowActions& actions;
        ui::RegistrationPanel& panel;
        ui::ResultPanel& result;
        ui::PosePanel& posePanel;
        ui::GeometryPanel& geometryPanel;
        ui::TreeView& treeView;
        ui::BottomStrip& strip;
    };
    explicit RunController(const Parts& parts, QObject* parent = nullptr);

    void show();   ///< options, and why a run cannot start

    /// What the status line says of a run that ended.
    static QString finishedText(const core::RegistrationResult& result);

private:
    void connectCommands();
    void connectRun();
    void start();
    void stop();
    void changeOptions(const core::RegistrationOptions& options, const ui::Words& label);
    void showRunning(bool running);
    void showProgress(const RunReport& report);
    void showFinished(const core::RegistrationResult& result);

    Parts on_;
};

}   // namespace angiopose::app