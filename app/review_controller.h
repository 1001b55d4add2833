#pragma once

#include "app/case_document.h"
#include "app/view_sync.h"

#include <QObject>
#include <QTimer>

namespace ui {
class MainWindow;
}

namespace app {

/// How the user looks at the case: overlay style, flicker, frames, theme. Nothing here changes the case but the frame.
class ReviewController : public QObject {
    Q_OBJECT
public:
    ReviewController(CaseDocument& document, ViewSync& sync, ui::MainWindow& window, QObject* parent = nullptr);

    void stepFrame(int step);   ///< as AngiogramView::frameStepRequested
    void showFrame(int frame);
    void stopMotion();   ///< ends flicker and cine

private:
    void connectOverlay();
    void connectMotion();
    void connectWindow();
    void updateOverlayMode();
    void setFlickering(bool on);
    void flick();
    void setPlaying(bool on);
    void changeOpacity(double by);
    void applyTheme(const QString& name);

    CaseDocument& document_;
    ViewSync& sync_;
    ui::MainWindow& window_;
    QTimer flickerTimer_;
    QTimer cineTimer_;
    bool showsStart_ = false;
    bool overlayHeldHidden_ = false;
    int frameBurst_ = 0;
    qint64 lastFrameMs_ = 0;
};

}   // namespace app
