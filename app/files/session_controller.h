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
#include "app/showing/notices.h"

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

/// From the first start to the last window: notice, opening, saving, exporting, recovery and closing.
class SessionController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::WelcomePage& welcome;
        ui::AngiogramView& view;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    SessionController(CaseDocument& document, TargetProvider& target, RegistrationController& registration,
                      const PosePreview& preview, Notices& notices, const Ui& ui, QObject* parent = nullptr);
    ~SessionController() override;

    /// Notice, recovery offer and the files of the command line.
    void begin(const QStringList& paths);
    void open(const QStringList& paths) { open_.open(paths); }
    void closeWindow() { close_.closeWindow(); }   ///< asks first where something would be lost
    void abandonLoading();
    bool isLoading() const { return open_.isLoading() || studies_.isLooking(); }
    bool isWriting() const { return pack_.isRunning() || deidentify_.isRunning(); }   ///< what may take long

    SaveController& saving() { return save_; }
    ExportController& exporting() { return export_; }
    AuditController& audit() { return audit_; }
    OpenController& opening() { return open_; }

signals:
    void restarted();   ///< for the first time, the notice read and no file given
    void exported();
    void aboutToClose();   ///< the user asked for it; what must not stay open ends now
    void windowMayClose();   ///< nothing is lost with it

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
    void tellWritten(const QString& there, const QStringList& notes);
    void start(const QStringList& paths);
    void showNotice(const QStringList& paths);
    void openNewWindow();
    void offerRecoveryOnce();

    CaseDocument& document_;
    Notices& notices_;
    Ui ui_;
    OpenController open_;
    ExportController export_;
    ReportController report_;
    DicomController dicom_;
    PackController pack_;
    DeidentifyController deidentify_;
    SaveController save_;
    OpenDialogs dialogs_;
    StudyController studies_;
    CloseController close_;
    RecentController recent_;
    std::unique_ptr<ArchiveController> archive_;
    std::unique_ptr<ArchiveSender> sender_;
    PrivacyController privacy_;
    AuditController audit_;
    bool offersRecovery_ = false;   ///< when the files of the command line are open, or could not be opened
    QStringList openingNotes_;
};

}   // namespace angiopose::app