#pragma once

#include "app/document/case_document.h"
#include "app/files/opening.h"
#include "app/jobs/load_job.h"

#include <QObject>

namespace angiopose::app {

/// Items that the user selected from the studies in a folder.
struct StudyChoice {
    QString folder, seriesId;   ///< folder and series of the vessels; empty if none were selected
    QStringList runs;   ///< angiogram files to open as views
};

/// Opens files: complete cases, inputs that form a new case, and inputs that are added to the open one. Reads on a
/// worker; the open case does not change until all files have been read and all questions answered.
class OpenController : public QObject {
    Q_OBJECT
public:
    explicit OpenController(CaseDocument& document, QObject* parent = nullptr);

    void open(const QStringList& paths);
    /// Opens a copy of the case at `original`, which is empty if the case was never saved. The case counts as unsaved.
    void openCopy(const QString& copy, const QString& original);
    /// Answers `seriesChoiceNeeded`: opens one of the offered series.
    void openSeries(const QString& seriesId);
    /// Opens the vessels and the first run together, as a new case or as part of the open one, and then the other runs
    /// as additional views.
    void openStudy(const StudyChoice& choice);
    /// Opens an angiogram, or the image of a case, as another view of the open case's vessels.
    void openView(const QStringList& paths);
    /// Answers `unitNeeded`.
    void openInUnit(double unitMm);
    /// Answers `scanChoiceNeeded`.
    void openScan(io::ScanUse use);
    /// Answers `viewChoiceNeeded`.
    void addPendingView();
    void replaceImage();
    /// Answers `mismatchNeedsConsent`.
    void openMismatched(bool isSamePatient);
    /// Answers `cameraChoiceNeeded`.
    void openPendingPose(IncomingCamera camera);
    /// Answers `inputsMissing`: opens the case without optional inputs.
    void openWithoutOptional();
    /// Answers `inputsMissing` with the locations of some inputs, or with another folder to search.
    void openWithInputs(const io::MovedInputs& moved, const QString& searchFolder = {});
    /// Returns the copy from which the open case was read; empty if it was not read from a copy.
    QString openedCopy() const { return originalPath_ ? copyPath_ : QString(); }
    void abandon();
    bool isLoading() const { return job_ != nullptr; }

signals:
    void inputsAdded(const core::Messages& warnings);   ///< warnings about files that are now part of the case
    void started(const QString& what);
    void progressed(const QString& what, double fraction);
    /// Emitted if a DICOM folder contains several series; answer with `openSeries` or do nothing.
    void seriesChoiceNeeded(const QString& folder, const std::vector<io::DicomSeries>& series);
    void ended();
    /// Emitted if only a folder or DICOMDIR was opened; answer with `openStudy` or do nothing.
    void studyOffered(const QString& place);
    /// Emitted if files named by a case were not found; answer with `openWithInputs` or do nothing.
    void inputsMissing(const QString& casePath, const QStringList& missing, bool areOptional);
    /// Emitted if a scan was opened while the case has vessels from a file. The question is whether to show the scan
    /// with them or to trace vessels in it; answer with `openScan` or do nothing.
    void scanChoiceNeeded(const QString& name);
    /// Emitted if vessels without a unit are implausibly small or large in mm; answer with `openInUnit` or do nothing.
    void unitNeeded(const QString& name, double unitsAcross);
    /// Emitted if an angiogram was opened while the case already has one. The question is whether to add a view or to
    /// replace the image; answer with `addPendingView`, `replaceImage` or do nothing.
    void viewChoiceNeeded(const QString& name);
    /// Emitted if a pose comes with a camera other than that of the case; answer with `openPendingPose` or do nothing.
    void cameraChoiceNeeded(const QString& name);
    /// Emitted if the opened files seem to belong to another patient or to the other body side; answer with
    /// `openMismatched` or do nothing.
    void mismatchNeedsConsent(const QString& names, const core::Messages& mismatch, const core::Case& wanted);
    void opened(const QStringList& notes);   ///< emitted after opening; `notes` holds remarks for the user
    void poseOpened(const QStringList& notes);   ///< emitted when a pose or points were applied to the open case
    void failed(const QString& reason, const QStringList& paths);
    /// Emitted before an open case with unsaved changes is replaced; answer with `replaceOpenCase` or do nothing.
    void replacementNeedsConsent();

public slots:
    void replaceOpenCase();

private:
    void load(const QStringList& paths, const io::OpenHints& hints);
    bool requestDecision(const io::LoadedInputs& inputs, const QStringList& paths);
    void take(const io::LoadedInputs& inputs, const QStringList& paths);
    void confirmPatient(const Opening& opening);
    void apply(const Opening& opening);
    void applyShared(const io::LoadedInputs& inputs, const QStringList& paths);
    void applyOpenedPose(const io::PoseWithCamera& pose, IncomingCamera camera, const QString& name);
    void openNextRun();
    io::ScanUse scanUse() const;
    void finish();

    CaseDocument& document_;
    LoadJob* job_ = nullptr;
    std::optional<Opening> pendingOpening_;   ///< files that have been read and await the user's consent
    std::optional<io::PoseWithCamera> pendingPose_;   ///< pose whose camera differs from that of the case
    QString pendingPoseName_;
    QString pendingSeries_;   ///< series of the scan about which the user is being asked
    QStringList furtherRuns_;   ///< further runs of a study, to be opened as views
    QStringList pendingPaths_;   ///< paths about which the user is being asked for the series or missing inputs
    bool opensAsView_ = false;   ///< true if the files being opened become an additional view
    io::MovedInputs movedInputs_;   ///< inputs located so far, for a case with missing inputs
    std::optional<QString> originalPath_;   ///< for a recovered copy, the path of its case
    QString copyPath_;
};

}   // namespace angiopose::app
