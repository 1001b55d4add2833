#pragma once

#include "app/document/case_document.h"
#include "app/files/open_controller.h"
#include "app/files/save_controller.h"
#include "app/jobs/file_queue.h"
#include "app/showing/notifications.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
class WelcomePage;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Asks the questions that arise on opening: which files and series to open, where moved inputs are, how to use an
/// additional scan or angiogram, which unit a surface has, and whether to replace the open case.
class OpenDialogs : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the class uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::WelcomePage& welcome;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    OpenDialogs(CaseDocument& document, OpenController& open, SaveController& save, Notifications& notifications,
                const Ui& ui, QObject* parent = nullptr);

private:
    void askForFiles();
    void askForFolder();
    void askForViewFiles();
    void openSample();
    void chooseSeries(const QString& folder, const std::vector<io::DicomSeries>& series);
    void askForInputs(const QString& casePath, const QStringList& missing, bool areOptional);
    void askForViewChoice(const QString& name);
    void askForCameraChoice(const QString& name);
    void confirmPatientMismatch(const QString& names, const core::Messages& mismatch, const core::Case& wanted);
    void askForScanUse(const QString& name);
    void askForUnit(const QString& name, double unitsAcross);
    void confirmReplace();

    CaseDocument& document_;
    OpenController& openController_;
    SaveController& saveController_;
    Notifications& notifications_;
    Ui ui_;
    FileQueue files_;   ///< runs the job that generates the sample case
};

}   // namespace angiopose::app
