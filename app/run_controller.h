#pragma once

#include "app/document/case_document.h"
#include "app/files/session_controller.h"
#include "app/registration/registration_controller.h"
#include "app/review/evaluation_controller.h"
#include "app/showing/notifications.h"
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

/// Manages Register and Stop, the options of the method, and the display during and after registration.
class RunController : public QObject {
    Q_OBJECT
public:
    /// Objects that run the registration or show its progress and result.
    struct Parts {
        CaseDocument& document;
        RegistrationController& registration;
        SessionController& session;
        ReviewController& review;
        EvaluationController& evaluation;
        ViewSync& sync;
        PosePreview& preview;
        Notifications& notifications;
        ui::WindowActions& actions;
        ui::RegistrationPanel& panel;
        ui::ResultPanel& result;
        ui::PosePanel& posePanel;
        ui::GeometryPanel& geometryPanel;
        ui::TreeView& treeView;
        ui::BottomStrip& strip;
    };
    explicit RunController(const Parts& parts, QObject* parent = nullptr);

    void show();   ///< updates the displayed options and the reason why registration cannot start

    /// Returns the status text of a completed registration.
    static QString finishedText(const core::RegistrationResult& result);

private:
    void connectCommands();
    void connectRun();
    void start();
    void stop();
    void changeOptions(const core::RegistrationOptions& options, const ui::LocalizedText& label);
    void showRunning(bool running);
    void showProgress(const RunReport& report);
    void showFinished(const core::RegistrationResult& result);

    Parts parts_;
};

}   // namespace angiopose::app
