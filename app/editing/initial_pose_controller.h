#pragma once

#include "app/document/case_document.h"

namespace angiopose::ui {
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Sets the initial pose of registration, either from the gantry angles or to the current pose after manual adjustment.
/// Each change is one undo step.
class InitialPoseController : public QObject {
    Q_OBJECT
public:
    InitialPoseController(CaseDocument& document, const ui::WindowActions& actions, QObject* parent = nullptr);

    void setFromAngles();
    void setFromCurrentPose();

signals:
    void refused(const QString& reason);
    void done(const QString& note);

private:
    CaseDocument& document_;
};

}   // namespace angiopose::app
