#pragma once

#include "app/document/case_document.h"
#include "app/files/close_controller.h"
#include "app/files/deidentify_controller.h"
#include "app/files/dicom_controller.h"
#include "app/files/export_controller.h"
#include "app/files/open_controller.h"
#include "app/files/open_dialogs.h"
#include "app/files/privacy_controller.h"
#include "app/files/recent_controller.h"
#include "app/files/save_controller.h"
#include "app/files/study_controller.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/showing/notifications.h"

#include <QObject>
#include <QStringList>

#include <memory>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
class WelcomePage;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

class ArchiveController;
class ArchiveSender;

/// Manages the session: notice, opening, saving, exporting, recovery and closing.
class SessionController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::WelcomePage& welcome;
        ui::AngiogramView& view;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    SessionController(CaseDocument& document, TargetProvider& target, RegistrationController& registration,
                      const PosePreview& preview, Notifications& notifications, const Ui& ui,
                      QObject* parent = nullptr);
    ~SessionController() override;

    /// Shows the notice and the recovery offer, and opens the files given on the command line.
    void begin(const QStringList& paths);
    void open(const QStringList& paths) { openController_.open(paths); }
    void closeWindow() { closeController_.closeWindow(); }   ///< asks first if unsaved work would be lost
    void abandonLoading();
    bool isLoading() const { return openController_.isLoading() || studyController_.isReading(); }
    bool isWriting() const
    {
        return packController_.isRunning() || deidentifyController_.isRunning();
    }   ///< jobs that may take long

    SaveController& saveController() { return saveController_; }
    ExportController& exportController() { return exportController_; }
    AuditController& audit() { return auditController_; }
    OpenController& openController() { return openController_; }

signals:
    void firstStarted();   ///< emitted at the first start, after the notice, if no files are opened
    void exported();
    void aboutToClose();   ///< emitted when the user requests closing; receivers close what must not stay open
    void windowMayClose();   ///< emitted when the window can close without losing data

private:
    void connectFiles();
    void connectOpening();
    void connectSaving();
    void connectExporting();
    void connectDicom();
    void connectPacking();
    void connectArchives();
    void connectDeidentifying();
    void connectAudit(RegistrationController& registration);
    void reportWritten(const QString& there, const QStringList& notes);
    void start(const QStringList& paths);
    void showNotice(const QStringList& paths);
    void openNewWindow();
    void offerRecoveryIfPending();

    CaseDocument& document_;
    Notifications& notifications_;
    Ui ui_;
    OpenController openController_;
    ExportController exportController_;
    ReportController reportController_;
    DicomController dicomController_;
    PackController packController_;
    DeidentifyController deidentifyController_;
    SaveController saveController_;
    OpenDialogs dialogs_;
    StudyController studyController_;
    CloseController closeController_;
    RecentController recentController_;
    std::unique_ptr<ArchiveController> archiveController_;
    std::unique_ptr<ArchiveSender> archiveSender_;
    PrivacyController privacyController_;
    AuditController auditController_;
    bool isRecoveryPending_ =
        false;   ///< true until the files from the command line were handled; recovery is offered then
    QStringList openingNotes_;
};

}   // namespace angiopose::app
