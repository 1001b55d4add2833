#pragma once

#include "app/document/case_document.h"
#include "app/jobs/load_job.h"

#include <QObject>

namespace app {

/// Opens files into the document: cases, or parts that make a case or join the open one. Reading happens on a worker;
/// the open case stays as it is until everything has been read.
class OpenController : public QObject {
    Q_OBJECT
public:
    explicit OpenController(CaseDocument& document, QObject* parent = nullptr);

    void open(const QStringList& paths) { load(paths, {}); }
    /// Answers `seriesChoiceNeeded`: opens one of the series that were offered.
    void openSeries(const QString& seriesId) { load(offeredPaths_, seriesId); }
    void abandon();
    bool isLoading() const { return job_ != nullptr; }

signals:
    void started(const QString& what);
    void advanced(const QString& what, double fraction);
    /// A DICOM folder holds several series; answer with `openSeries` or nothing.
    void seriesChoiceNeeded(const QString& folder, const std::vector<io::DicomSeries>& series);
    void ended();
    void opened(const QStringList& notes);   ///< what to know about the files, in words
    void failed(const QString& reason, const QStringList& paths);
    /// Asked before the open case, with unsaved changes, is replaced; answer with `replaceOpenCase` or nothing.
    void replacementNeedsConsent();

public slots:
    void replaceOpenCase();

private:
    void load(const QStringList& paths, const QString& seriesId);
    void take(const LoadedInputs& inputs, const QStringList& paths);
    void replaceWith(const LoadedInputs& inputs, const QString& path);
    void join(const LoadedInputs& inputs, const QStringList& paths);
    void finish();

    CaseDocument& document_;
    LoadJob* job_ = nullptr;
    std::optional<LoadedInputs> waiting_;   ///< read, but the user still has to agree
    QString waitingPath_;
    QStringList offeredPaths_;   ///< what was opened when a choice of series was asked for
};

}   // namespace app
