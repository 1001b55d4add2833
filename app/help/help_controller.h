#pragma once

#include "app/jobs/file_queue.h"

#include <QObject>
#include <QPointer>

namespace angiopose::ui {
class GoodFit;
class MainWindow;
class Tour;
}   // namespace angiopose::ui
namespace angiopose::app {

/// Provides context help, the tour, and the page of good and bad fits. Uses the whole window because it explains every
/// part of it.
class HelpController : public QObject {
    Q_OBJECT
public:
    explicit HelpController(ui::MainWindow& window, QObject* parent = nullptr);

    void offerTour();   ///< offers the tour only at the first start

private:
    void showPage();
    void startTour();
    void showFitExamples();
    void loadFitExample(int index);
    void showAbout();
    QString rendererDescription() const;

    ui::MainWindow& window_;
    QPointer<ui::Tour> tour_;
    QPointer<ui::GoodFit> goodFit_;
    FileQueue exampleImages_;
};

}   // namespace angiopose::app
