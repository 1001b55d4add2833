#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace angiopose::app {
class CaseController;
}

namespace angiopose::ui {
class MainWindow;
class SliceModel;
enum class Step;
}   // namespace angiopose::ui

namespace angiopose::test {

/// Takes screenshots of the window, its panels and dialogs in one language and theme, and looks for visible defects:
/// clipped texts and empty panels.
class Gallery {
public:
    /// With an empty `folder`, only checks and writes no screenshots.
    Gallery(QString folder, QString language, QString theme);

    void run();
    void runScan(const QString& path);   ///< of one scan, in the slices and in 3-D
    const QStringList& problems() const { return problems_; }
    int pictureCount() const { return pictureCount_; }

private:
    static void measure(app::CaseController& controller);
    void showDialogs(ui::MainWindow& window);
    void showRareDialogs(ui::MainWindow& window);
    void showStudies(ui::MainWindow& window);
    void showArchives(ui::MainWindow& window);
    void showTrial(ui::MainWindow& window, app::CaseController& controller);
    void showViews(ui::MainWindow& window, app::CaseController& controller);
    void showModes(ui::MainWindow& window);
    void showQuestions(ui::MainWindow& window, app::CaseController& controller);
    static void goToStep(ui::MainWindow& window, ui::Step step);
    void showSteps(ui::MainWindow& window);
    void showScanIn3d(ui::MainWindow& window);
    static void openScan(app::CaseController& controller, const QString& path);
    void measureSlices(app::CaseController& controller, const ui::SliceModel& slices);
    void showScan(ui::MainWindow& window, app::CaseController& controller);
    void takeDialogs(QWidget& window, const QString& name);   ///< all open dialogs; closes them
    void showWindow(QWidget& window, const QString& name);
    void showPanels(QWidget& window);
    void take(QWidget& widget, const QString& name);

    QString folder_;
    QString language_;
    QString theme_;
    QStringList problems_;
    int pictureCount_ = 0;
};

}   // namespace angiopose::test
