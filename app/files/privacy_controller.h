#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "io/sharing/audit_file.h"

#include <QObject>
#include <QStringList>

class QAction;
class QWidget;

namespace angiopose::app {

/// Switches private mode on and off: asks before deleting stored data, and clears data when the window closes.
class PrivacyController : public QObject {
    Q_OBJECT
public:
    PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent = nullptr);
    ~PrivacyController() override;

signals:
    void changed();   ///< the stored and displayed data have changed

private:
    void choose(bool on);
    void turnOn();
    void turnOff();

    QAction& mode_;
    QWidget& dialogParent_;
};

/// Writes the audit file, which records who opened and wrote which files. Set by the environment or by the menu switch,
/// which asks for the file; off by default.
class AuditController : public QObject {
    Q_OBJECT
public:
    AuditController(const CaseDocument& document, QAction& keep, QWidget& dialogParent, QObject* parent = nullptr);

    void note(io::AuditEvent event, const QStringList& paths);   ///< returns at once
    void noteOpened();   ///< records the open case and its inputs
    void noteCase(io::AuditEvent event);   ///< records an event of the open case's own file

signals:
    void failed(const QString& reason);   ///< an event could not be recorded

private:
    void choose(bool on);

    const CaseDocument& document_;
    QAction& keep_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app
