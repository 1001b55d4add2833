#pragma once

#include "app/archive/archive_finder.h"
#include "app/archive/archive_list.h"
#include "app/archive/storage_scp_service.h"

#include <QObject>
#include <QPointer>

class QAction;
class QWidget;

namespace angiopose::ui {
class ArchiveDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

class ArchiveNodes;
class ArchiveRetrieval;

/// Queries an archive, retrieves or receives its images, and offers to open them.
class ArchiveController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        QAction& hideIdentity;
        QWidget& dialogParent;
    };
    explicit ArchiveController(const Ui& ui, QObject* parent = nullptr);

    void show();
    ArchiveList& list() { return list_; }

signals:
    /// Emitted with the folders of the retrieved series and a common display name.
    void retrieved(const QStringList& folders, const QString& name);
    void reported(const QString& words);   ///< emitted with a message of the storage SCP while the dialog is closed
    void auditFailed(const QString& reason);   ///< emitted when received objects are missing from the audit file

private:
    void connectParts();
    void connectScpService();
    void retrieve();
    void offerToOpen(const QStringList& folders, const QString& name);
    void setScpEnabled(bool isOn);
    void showPort();
    QString scpStatusText() const;

    Ui ui_;
    ArchiveList list_;
    StorageScpService scpService_;
    ArchiveSearchResults searchResults_;
    QPointer<ui::ArchiveDialog> dialog_;
    ArchiveNodes* nodes_ = nullptr;   ///< owned by the dialog
    ArchiveFinder* finder_ = nullptr;
    ArchiveRetrieval* retrieval_ = nullptr;
};

}   // namespace angiopose::app
