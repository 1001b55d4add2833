#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "ui/dialogs/pack_dialog.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The case with its inputs in one archive, as it stands: asked for, then written by a worker with progress and Stop.
class PackController : public QObject {
    Q_OBJECT
public:
    PackController(CaseDocument& document, ui::BottomStrip& strip, QWidget& dialogParent, QObject* parent = nullptr);

    void ask();
    void write(const ui::PackChoice& choice, const QString& path);   ///< returns at once
    bool isRunning() const { return job_.isRunning(); }

signals:
    void stopped();
    void written(const QString& path, const QStringList& notes);
    void failed(const QString& reason);

private:
    void askPath(const ui::PackChoice& choice);

    CaseDocument& document_;
    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    QString archive_;   ///< that is being written
    Job<QStringList> job_;   ///< the notes on it
};

}   // namespace angiopose::app
