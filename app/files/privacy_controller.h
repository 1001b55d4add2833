#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "io/sharing/audit_file.h"

#include <QObject>
#include <QStringList>

class QAction;
class QWidget;

namespace angiopose::app {

/// Private mode, on and off: asks before it forgets, and clears up when the window goes.
class PrivacyController : public QObject {
    Q_OBJECT
public:
    PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent = nullptr);
    ~PrivacyController() override;

signals:
    void changed();   ///< what is remembered and shown is another now

private:
    void choose(bool on);
    void turnOn();
    void turnOff();

    QAction& mode_;
    QWidget& dialogParent_;
};

/// The file that says who opened and wrote what, where one is wished: by the environment, or by the switch in the menu,
/// which asks where. Off unless somebody says so.
class AuditController : public QObject {
    Q_OBJECT
public:
    AuditController(const CaseDocument& document, QAction& keep, QWidget& dialogParent, QObject* parent = nullptr);

    void note(io::AuditEvent event, const QStringList& paths);   ///< returns at once
    void noteOpened();   ///< the open case and what it was made of
    void noteCase(io::AuditEvent event);   ///< of the open case's own file

signals:
    void failed(const QString& reason);   ///< what was done is not in the file

private:
    void choose(bool on);

    const CaseDocument& document_;
    QAction& keep_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app
