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

/// Asks an archive whether it answers, and says so in a line.
class ArchiveEcho : public QObject {
    Q_OBJECT
public:
    explicit ArchiveEcho(ui::TransferLine& line, QObject* parent = nullptr);

    void ask(const io::ArchiveNode& node);

private:
    void tell(const core::Messages& notes);

    ui::TransferLine& line_;
    QString name_;
    Job<core::Messages> job_;
};

/// The list of archives in a dialog: chosen, tested, added, edited, removed.
class ArchiveNodes : public QObject {
    Q_OBJECT
public:
    /// What of the dialog it serves.
    struct Ui {
        ui::NodeBar& bar;
        ui::TransferLine& line;
        QWidget& dialog;
    };
    ArchiveNodes(ArchiveList& list, const Ui& ui, QObject* parent = nullptr);

    std::optional<io::ArchiveNode> node() const;   ///< that is chosen

signals:
    void chosen();   ///< the same one or another, or none

private:
    void show();
    void test();
    void add();
    void edit();
    void askRemoval();
    void save(const ui::ArchiveEntry& entry, const QString& former);
    void openDialog(const ui::ArchiveEntry& entry, const QString& former);

    ArchiveList& list_;
    Ui ui_;
    ArchiveEcho echo_;
    QPointer<ui::NodeDialog> editor_;
};

}   // namespace angiopose::app
