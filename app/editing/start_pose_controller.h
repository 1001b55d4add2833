#pragma once

#include "app/document/case_document.h"

namespace angiopose::ui {
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Where a registration starts from: the angles, or the pose as it has been moved by hand. One step of undo each.
class StartPoseController : public QObject {
    Q_OBJECT
public:
    StartPoseController(CaseDocument& document, const ui::WindowActions& actions, QObject* parent = nullptr);

    void startFromAngles();
    void startHere();

signals:
    void refused(const QString& reason);
    void done(const QString& note);

private:
    CaseDocument& document_;
};

}   // namespace angiopose::app