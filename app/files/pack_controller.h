#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "ui/dialogs/pack_dialog.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace angiopose::app {

/// The case with its inputs in one archive, as it stands: asked for, then written by a worker.
class PackController : public QObject {
    Q_OBJECT
public:
    PackController(CaseDocument& document, QWidget& dialogParent, QObject* parent = nullptr);

    void ask();
    void write(const ui::PackChoice& choice, const QString& path);   ///< returns at once

signals:
    void started();
    void written(const QString& path, const QStringList& notes);
    void failed(const QString& reason);

private:
    void askPath(const ui::PackChoice& choice);

    CaseDocument& document_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app
