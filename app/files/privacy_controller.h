#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "io/sharing/audit_file.h"

#include <QObject>
#include <QStringList>

class QAction;
class QWidget;

namespace angiopose::app {

/// Switches private mode on and off. Asks before deleting stored data, and deletes such data when the window closes.
class PrivacyController : public QObject {
    Q_OBJECT
public:
    PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent = nullptr);
    ~PrivacyController() override;

signals:
    void changed();   ///< emitted when stored and displayed data have changed

private:
    void choose(bool on);
    void turnOn();
    void turnOff();

    QAction& privateModeAction_;
    QWidget& dialogParent_;
};

/// Writes the audit file, which records who opened and wrote which files. Off by default; either the environment
/// variable sets the file, or the menu command, which asks for one.
class AuditController : public QObject {
    Q_OBJECT
public:
    AuditController(const CaseDocument& document, QAction& keep, QWidget& dialogParent, QObject* parent = nullptr);

    void note(io::AuditEvent event, const QStringList& paths);   ///< records an event; returns at once
    void noteOpened();   ///< records the open case and its inputs
    void noteCase(io::AuditEvent event);   ///< records an event that concerns the case file itself

signals:
    void failed(const QString& reason);   ///< emitted if an event could not be recorded

private:
    void choose(bool on);

    const CaseDocument& document_;
    QAction& auditAction_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app
