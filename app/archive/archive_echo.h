#pragma once

#include "app/jobs/job.h"
#include "io/archive/archive.h"

#include <QObject>

namespace angiopose::ui {
class TransferLine;
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

}   // namespace angiopose::app
