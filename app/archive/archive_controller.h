#pragma once

#include "app/archive/archive_finder.h"
#include "app/archive/archive_list.h"
#include "app/archive/archive_port.h"

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

/// Images from an archive: found, retrieved or received, then offered to be opened.
class ArchiveController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        QAction& hideIdentity;
        QWidget& dialogParent;
    };
    explicit ArchiveController(const Ui& ui, QObject* parent = nullptr);

    void show();
    ArchiveList& list() { return list_; }

signals:
    /// Folders of series, and what they are called together.
    void retrieved(const QStringList& folders, const QString& name);
    void reported(const QString& words);   ///< of the port, while the dialog is closed
    void unaudited(const QString& reason);   ///< what came is not in the audit file

private:
    void connectParts();
    void connectPort();
    void retrieve();
    void offer(const QStringList& folders, const QString& name);
    void switchPort(bool isOn);
    void showPort();
    QString portWords() const;

    Ui ui_;
    ArchiveList list_;
    ArchivePort port_;
    ArchiveFindings findings_;
    QPointer<ui::ArchiveDialog> dialog_;
    ArchiveNodes* nodes_ = nullptr;   ///< these live as long as the dialog
    ArchiveFinder* finder_ = nullptr;
    ArchiveRetrieval* retrieval_ = nullptr;
};

}   // namespace angiopose::app
