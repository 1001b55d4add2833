#pragma once

#include "app/archive/archive_echo.h"
#include "app/archive/archive_list.h"

#include <QObject>
#include <QPointer>

namespace angiopose::ui {
class NodeBar;
class NodeDialog;
struct ArchiveEntry;
}   // namespace angiopose::ui

namespace angiopose::app {

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
