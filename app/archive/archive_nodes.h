#pragma once

#include "app/archive/archive_list.h"
#include "app/jobs/job.h"
#include "io/archive/archive.h"

#include <QObject>
#include <QPointer>

namespace angiopose::ui {
class NodeBar;
class NodeDialog;
class TransferLine;
struct ArchiveEntry;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Tests the connection to an archive (C-ECHO) and shows the outcome in a status line.
class ArchiveEcho : public QObject {
    Q_OBJECT
public:
    explicit ArchiveEcho(ui::TransferLine& line, QObject* parent = nullptr);

    void sendEcho(const io::ArchiveNode& node);

private:
    void showEchoResult(const core::Messages& notes);

    ui::TransferLine& statusRow_;
    QString name_;
    Job<core::Messages> job_;
};

/// Manages the list of archives in a dialog: select, test, add, edit and remove.
class ArchiveNodes : public QObject {
    Q_OBJECT
public:
    /// Parts of the dialog that the class uses.
    struct Ui {
        ui::NodeBar& bar;
        ui::TransferLine& line;
        QWidget& dialog;
    };
    ArchiveNodes(ArchiveList& list, const Ui& ui, QObject* parent = nullptr);

    std::optional<io::ArchiveNode> node() const;   ///< the selected archive

signals:
    void archiveSelected();   ///< emitted when the selection changes or the same archive is selected again

private:
    void show();
    void test();
    void add();
    void edit();
    void confirmRemoval();
    void save(const ui::ArchiveEntry& entry, const QString& former);
    void openDialog(const ui::ArchiveEntry& entry, const QString& former);

    ArchiveList& list_;
    Ui ui_;
    ArchiveEcho echo_;
    QPointer<ui::NodeDialog> editor_;
};

}   // namespace angiopose::app
