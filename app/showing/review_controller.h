#pragma once

#include "app/document/case_document.h"
#include "app/showing/view_sync.h"

#include <QObject>
#include <QTimer>

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Controls the display during review: flicker, frames and theme. Only a change of frame changes the case.
class ReviewController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::BottomStrip& strip;
    };

    ReviewController(CaseDocument& document, ViewSync& sync, PosePreview& preview, const Ui& ui,
                     QObject* parent = nullptr);

    void stepFrame(int step);   ///< see AngiogramView::frameStepRequested
    void showFrame(int frame);
    void stopMotion();   ///< stops all animations

private:
    void connectMotion();
    void connectWindow();
    void connectShape();
    void showShapeNote(const QString& note);
    void setFlickering(bool on);
    void toggleFlickerPose();
    void applyTheme(const QString& name);

    CaseDocument& document_;
    ViewSync& sync_;
    PosePreview& preview_;
    Ui ui_;
    QTimer flickerTimer_;
    bool showsInitialPose_ = false;
    int frameMergeId_ = 0;
    qint64 lastFrameChangeMs_ = 0;
};

}   // namespace angiopose::app
