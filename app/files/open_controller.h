#pragma once

#include "app/document/case_document.h"
#include "app/files/opening.h"
#include "app/jobs/load_job.h"

#include <QObject>

namespace angiopose::app {

/// What was chosen of the studies in a folder.
struct StudyChoice {
    QString folder, seriesId;   ///< of the vessels; empty: none
    QStringList runs;   ///< files of the views
};

/// Opens files: cases, or parts that make a case or join the open one. Reading happens on a worker; the open case stays
/// as it is until everything has been read and whatever had to be asked is answered.
class OpenController : public QObject {
    Q_OBJECT
public:
    explicit OpenController(CaseDocument& document, QObject* parent = nullptr);

    void open(const QStringList& paths);
    /// Opens the copy of a case that lives at `original` (empty: it was never saved); it counts as unsaved.
    void openCopy(const QString& copy, const QString& original);
    /// Answers `seriesChoiceNeeded`: opens one of the series that were offered.
    void openSeries(const QString& seriesId);
    /// Opens vessels and the first run together, as a case or into the open one, and the other runs as further views.
    void openStudy(const StudyChoice& choice);
    /// Opens an angiogram, or the image of a case, as another view of the open case's vessels.
    void openView(const QStringList& paths);
    /// Answers `unitNeeded`.
    void openInUnit(double unitMm);
    /// Answers `scanChoiceNeeded`.
    void openScan(io::ScanUse use);
    /// Answers `viewChoiceNeeded`.
    void addWaitingView();
    void replaceImage();
    /// Answers `mismatchNeedsConsent`.
    void openMismatched(bool isSamePatient);
    /// Answers `cameraChoiceNeeded`.
    void openWaitingPose(ArrivingCamera camera);
    /// Answers `inputsMissing`: opens without those that can be done without.
    void openWithoutOptional();
    /// Answers `inputsMissing`: where some of them lie, or another folder to search.
    void openWithInputs(const io::MovedInputs& moved, const QString& searchFolder = {});
    /// The copy that the open case came from; empty when it is no copy.
    QString openedCopy() const { return original_ ? copy_ : QString(); }
    void abandon();
    bool isLoading() const { return job_ != nullptr; }

signals:
    void tookIn(const core::Messages& warnings);   ///< said of files that are in the case now
    void started(const QString& what);
    void advanced(const QString& what, double fraction);
    /// A DICOM folder holds several series; answer with `openSeries` or nothing.
    void seriesChoiceNeeded(const QString& folder, const std::vector<io::DicomSeries>& series);
    void ended();
    /// A folder or DICOMDIR was opened by itself; answer with `openStudy` or nothing.
    void studyOffered(const QString& place);
    /// A case refers to files that were found nowhere; answer with `openWithInputs` or nothing.
    void inputsMissing(const QString& casePath, const QStringList& missing, bool areOptional);
    /// A scan was opened while the case has vessels of a file: to be seen beside them, or to trace vessels from?
    /// Answer with `openScan` or nothing.
    void scanChoiceNeeded(const QString& name);
    /// Vessels that say no unit are too small or large for mm; answer with `openInUnit` or nothing.
    void unitNeeded(const QString& name, double unitsAcross);
    /// An angiogram was opened while the case has one: another view, or instead of it? Answer with `addWaitingView`,
    /// `replaceImage` or nothing.
    void viewChoiceNeeded(const QString& name);
    /// A pose brings another camera than the case has; answer with `openWaitingPose` or nothing.
    void cameraChoiceNeeded(const QString& name);
    /// What was opened seems to be of another patient, or of the other side; answer with `openMismatched` or nothing.
    void mismatchNeedsConsent(const QString& names, const core::Messages& mismatch, const core::Case& wanted);
    void opened(const QStringList& notes);   ///< what to know about the files, in words
    void poseOpened(const QStringList& notes);   ///< a pose or points were taken into the open case
    void failed(const QString& reason, const QStringList& paths);
    /// Asked before the open case, with unsaved changes, is replaced; answer with `replaceOpenCase` or nothing.
    void replacementNeedsConsent();

public slots:
    void replaceOpenCase();

private:
    void load(const QStringList& paths, const io::OpenHints& hints);
    bool asksFirst(const io::LoadedInputs& inputs, const QStringList& paths);
    void take(const io::LoadedInputs& inputs, const QStringList& paths);
    void admit(const Opening& opening);
    void carryOut(const Opening& opening);
    void takeShared(const io::LoadedInputs& inputs, const QStringList& paths);
    void finishPose(const io::PoseWithCamera& pose, ArrivingCamera camera, const QString& name);
    void openNextRun();
    io::ScanUse scanUse() const;
    void finish();

    CaseDocument& document_;
    LoadJob* job_ = nullptr;
    std::optional<Opening> waiting_;   ///< read, but the user still has to agree
    std::optional<io::PoseWithCamera> waitingPose_;   ///< with another camera than the case's
    QString waitingPoseName_;
    QString askedSeries_;   ///< of the scan that is asked about
    QStringList furtherRuns_;   ///< of a study, to be opened as views
    QStringList askedPaths_;   ///< what was opened when a choice of series or the place of inputs was asked for
    bool asView_ = false;   ///< what is being opened becomes another view
    io::MovedInputs moved_;   ///< inputs found so far of the case that lacks some
    std::optional<QString> original_;   ///< of a copy, the last that was opened: where its case lives
    QString copy_;
};

}   // namespace angiopose::app