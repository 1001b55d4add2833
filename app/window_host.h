#pragma once

#include "app/case_controller.h"
#include "app/document/case_document.h"
#include "ui/main_window.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace app {

/// The window and all behind it. Another language or other keys need other words everywhere, so the window is made anew
/// then: the open case with its history stays, and so does what is seen of it.
class WindowHost : public QObject {
    Q_OBJECT
public:
    explicit WindowHost(QObject* parent = nullptr);
    ~WindowHost() override;

    ui::MainWindow& window() { return *window_; }
    CaseController& controller() { return *controller_; }

signals:
    void renewed();   ///< `window` and `controller` are others now

private:
    void make();
    void renewWhenIdle();   ///< a run, a trial or a file under way ends first
    void renew();

    std::shared_ptr<CaseDocument> document_;
    std::unique_ptr<ui::MainWindow> window_;
    std::unique_ptr<CaseController> controller_;
    QTimer retry_;
};

}   // namespace app
