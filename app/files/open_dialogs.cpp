#include "app/files/open_dialogs.h"

#include "app/files/sample_case.h"
#include "app/preferences/settings.h"
#include "app/texts/number_text.h"
#include "app/words/patient_words.h"
#include "io/dicom_series.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/dialogs/missing_inputs.h"
#include "ui/dialogs/series_chooser.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/welcome_page.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QFileDialog>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace angiopose::app {
namespace {

struct SeriesWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::SeriesRows)
};

QString numberedName(int number)
{
    return SeriesWords::tr("Series %1").arg(number);
}

QString sizeText(const io::DicomSeries& series)
{
    const io::SliceRecord& first = series.slices.front();
    const bool isPlanned = !series.isAngiogram && !series.problem;
    const Eigen::Vector3i size =
        isPlanned ? series.stack.geometry.size : Eigen::Vector3i(first.size.x(), first.size.y(), 0);
    const QString plane = QStringLiteral("%1 × %2").arg(size.x()).arg(size.y());
    return isPlanned ? plane + QStringLiteral(" × %1").arg(size.z()) : plane;
}

QString spacingText(const io::DicomSeries& series)
{
    if (series.isAngiogram || series.problem) {
        return {};
    }
    QStringList parts;
    for (const double spacing : series.stack.geometry.spacingMm) {
        parts << ui::numberText(spacing, 2);
    }
    return parts.join(QStringLiteral(" × "));
}

ui::SeriesRow rowOf(const io::DicomSeries& series)
{
    ui::SeriesRow row;
    row.id = QString::fromStdString(series.id);
    row.description =
        QString::fromStdString(series.description.empty() ? series.identity.description : series.description);
    if (row.description.isEmpty()) {
        row.description = numberedName(series.number);
    }
    if (series.part) {
        row.description += QStringLiteral(" (%1)").arg(ui::messageText(series.part));
    }
    row.modality = QString::fromStdString(series.identity.modality);
    row.imageCount = static_cast<int>(series.slices.size());
    row.size = sizeText(series);
    row.spacingMm = spacingText(series);
    row.date = QString::fromStdString(series.identity.studyDate);
    row.isOpenable = !series.problem;
    if (!row.isOpenable) {
        row.notes << ui::messageText(series.problem);
    }
    for (const core::Message& warning : series.warnings) {
        row.notes << ui::messageText(warning);
    }
    return row;
}

/// Builds the rows of the series chooser for a folder.
std::vector<ui::SeriesRow> seriesRows(const std::vector<io::DicomSeries>& series)
{
    std::vector<ui::SeriesRow> rows(series.size());
    std::ranges::transform(series, rows.begin(), rowOf);
    return rows;
}

struct KindWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::InputKind)
};

/// Name filters of the open dialog; the first filter covers all file types.
QStringList openFilters()
{
    const QString scans = QStringLiteral("*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.stl *.ply *.obj");
    const QString all = QStringLiteral(
        "*.angiopose *.vtp *.vtk *.csv *.swc *.json *.dcm *.png *.tif *.tiff *.jpg *.jpeg "
        "*.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv ");
    return {KindWords::tr("Cases, vessels and angiograms (%1)").arg(all + scans),
            KindWords::tr("Cases (*.angiopose)"),
            KindWords::tr("Centerlines (*.vtp *.vtk *.csv *.swc *.json)"),
            KindWords::tr("Scans and surfaces (%1 *.dcm)").arg(scans),
            KindWords::tr("Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)"),
            KindWords::tr("Poses and points (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)"),
            KindWords::tr("All files (*)")};
}

struct LengthUnit {
    const char* name;
    double mm;
};

/// Returns the units that give a plausible vessel size, most likely first; mm comes last because it gave an implausible
/// size. Returns all units if none fits.
std::vector<LengthUnit> unitsFor(double unitsAcross)
{
    constexpr double smallestMm = 10.0, usualMm = 200.0, largestMm = 2000.0;
    constexpr std::array others{LengthUnit{"cm", 10.0}, LengthUnit{"m", 1000.0}, LengthUnit{"µm", 0.001}};
    const auto leap = [unitsAcross](const LengthUnit& unit) {
        return std::abs(std::log(unitsAcross * unit.mm / usualMm));
    };
    std::vector<LengthUnit> units;
    std::ranges::copy_if(others, std::back_inserter(units), [unitsAcross](const LengthUnit& unit) {
        const double mm = unitsAcross * unit.mm;
        return mm >= smallestMm && mm <= largestMm;
    });
    if (units.empty()) {
        units.assign(others.begin(), others.end());
    }
    std::ranges::sort(units, {}, leap);
    units.push_back({"mm", 1.0});
    return units;
}

}   // namespace

OpenDialogs::OpenDialogs(CaseDocument& document, OpenController& open, SaveController& save,
                         Notifications& notifications, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      openController_(open),
      saveController_(save),
      notifications_(notifications),
      ui_(ui)
{
    connect(&openController_, &OpenController::seriesChoiceNeeded, this, &OpenDialogs::chooseSeries);
    connect(&openController_, &OpenController::inputsMissing, this, &OpenDialogs::askForInputs);
    connect(&openController_, &OpenController::scanChoiceNeeded, this, &OpenDialogs::askForScanUse);
    connect(&openController_, &OpenController::unitNeeded, this, &OpenDialogs::askForUnit);
    connect(&openController_, &OpenController::viewChoiceNeeded, this, &OpenDialogs::askForViewChoice);
    connect(&openController_, &OpenController::cameraChoiceNeeded, this, &OpenDialogs::askForCameraChoice);
    connect(&openController_, &OpenController::mismatchNeedsConsent, this, &OpenDialogs::confirmPatientMismatch);
    connect(&openController_, &OpenController::replacementNeedsConsent, this, &OpenDialogs::confirmReplace);
    connect(&ui_.welcome, &ui::WelcomePage::openRequested, this, &OpenDialogs::askForFiles);
    connect(&ui_.welcome, &ui::WelcomePage::folderRequested, this, &OpenDialogs::askForFolder);
    connect(&ui_.welcome, &ui::WelcomePage::sampleRequested, this, &OpenDialogs::openSample);
    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::Open], &QAction::triggered, this, &OpenDialogs::askForFiles);
    connect(actions[ui::Command::OpenFolder], &QAction::triggered, this, &OpenDialogs::askForFolder);
    connect(actions[ui::Command::OpenSample], &QAction::triggered, this, &OpenDialogs::openSample);
    connect(actions[ui::Command::AddView], &QAction::triggered, this, &OpenDialogs::askForViewFiles);
}

void OpenDialogs::askForFiles()
{
    auto* dialog = new QFileDialog(&ui_.dialogParent, tr("Open"), settings::lastFolder.read(),
                                   openFilters().join(QStringLiteral(";;")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
        settings::lastFolder.write(QFileInfo(paths.front()).absolutePath());
        openController_.open(paths);
    });
    dialog->open();
}

void OpenDialogs::askForFolder()
{
    auto* dialog = new QFileDialog(&ui_.dialogParent, tr("Open DICOM folder/CD"), settings::lastFolder.read());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        settings::lastFolder.write(folder);
        openController_.open({folder});
    });
    dialog->open();
}

void OpenDialogs::chooseSeries(const QString& folder, const std::vector<io::DicomSeries>& series)
{
    auto* chooser = new ui::SeriesChooser(folder, seriesRows(series), &ui_.dialogParent);
    connect(chooser, &ui::SeriesChooser::seriesChosen, &openController_, &OpenController::openSeries);
    chooser->open();
}

void OpenDialogs::askForViewFiles()
{
    auto* dialog = new QFileDialog(&ui_.dialogParent, tr("Add a view"), settings::lastFolder.read(),
                                   openFilters().join(QStringLiteral(";;")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        settings::lastFolder.write(QFileInfo(path).absolutePath());
        openController_.openView({path});
    });
    dialog->open();
}

void OpenDialogs::askForViewChoice(const QString& name)
{
    auto* question =
        new ui::QuestionDialog({tr("Another view of the same vessels?"),
                                tr("The case already has an angiogram. Add “%1” as a second view for joint "
                                   "registration, or replace the current angiogram?")
                                    .arg(name),
                                {}},
                               {tr("Add as a view"), tr("Replace the angiogram"), tr("Cancel")}, &ui_.dialogParent);
    question->setObjectName(QStringLiteral("viewQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 0) {
            openController_.addPendingView();
        } else if (index == 1) {
            openController_.replaceImage();
        } else {
            openController_.abandon();
        }
    });
    question->open();
}

void OpenDialogs::askForCameraChoice(const QString& name)
{
    auto* question =
        new ui::QuestionDialog({tr("Which camera should be used?"),
                                tr("“%1” contains a camera that differs from that of the case. The pose is valid only "
                                   "with the camera that was used for its registration.")
                                    .arg(name),
                                {}},
                               {tr("Use pose and camera"), tr("Use pose only"), tr("Cancel")}, &ui_.dialogParent);
    question->setObjectName(QStringLiteral("cameraQuestion"));
    question->setAnswerOnClose(2);
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 2) {
            openController_.abandon();
        } else {
            openController_.openPendingPose(index == 0 ? IncomingCamera::OfPose : IncomingCamera::OfCase);
        }
    });
    question->open();
}

void OpenDialogs::confirmPatientMismatch(const QString& names, const core::Messages& mismatch, const core::Case& wanted)
{
    const bool isHidden = ui_.actions[ui::Command::HideIdentity]->isChecked();
    const QString patients =
        isHidden ? QString() : QStringLiteral("\n\n") + patientLines(wanted).join(QLatin1Char('\n'));
    auto* question = new ui::QuestionDialog(
        {tr("Different patient?"),
         ui::messagesText(mismatch) + patients + QStringLiteral("\n\n") +
             tr("If you open “%1” anyway, every image and report of the case will carry a warning, and no registration "
                "in this case will be rated reliable. If only the pseudonyms differ, open it as the same patient.")
                 .arg(names),
         {}},
        {tr("Do not open"), tr("Open anyway"), tr("Open as same patient")}, &ui_.dialogParent);
    question->setObjectName(QStringLiteral("patientQuestion"));
    question->setAnswerOnClose(0);
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index > 0) {
            openController_.openMismatched(index == 2);
        } else {
            openController_.abandon();
        }
    });
    question->open();
}

void OpenDialogs::askForScanUse(const QString& name)
{
    auto* question =
        new ui::QuestionDialog({tr("Show the scan with the current vessels?"),
                                tr("The vessels of the case come from a file. Show the slices of “%1” with these "
                                   "vessels, or replace them with vessels traced in this scan?")
                                    .arg(name),
                                {}},
                               {tr("Show with the vessels"), tr("Trace this scan"), tr("Cancel")}, &ui_.dialogParent);
    question->setObjectName(QStringLiteral("scanQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index < 2) {
            openController_.openScan(index == 0 ? io::ScanUse::ShowWithVessels : io::ScanUse::Trace);
        }
    });
    question->open();
}

/// Asks for the unit. Each button shows the size that results; the most likely unit comes first.
void OpenDialogs::askForUnit(const QString& name, double unitsAcross)
{
    const std::vector<LengthUnit> units = unitsFor(unitsAcross);
    QStringList verbs;
    for (const LengthUnit& unit : units) {
        const double mm = unitsAcross * unit.mm;
        const QString size = mm < 10000.0 ? tr("%1 mm across").arg(ui::numberText(mm, mm < 10.0 ? 2 : 0))
                                          : tr("%1 m across").arg(ui::numberText(mm / 1000.0, 0));
        verbs << tr("%1: %2").arg(QString::fromUtf8(unit.name), size);
    }
    auto* question =
        new ui::QuestionDialog({tr("Which unit does the file use?"),
                                tr("“%1” does not specify the unit of its coordinates. If the unit were millimeters, "
                                   "the vessels would be unusually small or large. Your choice is stored in the case.")
                                    .arg(name),
                                {}},
                               verbs + QStringList{tr("Cancel")}, &ui_.dialogParent);
    question->setObjectName(QStringLiteral("unitQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this, units](int index) {
        if (index >= 0 && index < static_cast<int>(units.size())) {
            openController_.openInUnit(units[static_cast<std::size_t>(index)].mm);
        }
    });
    question->open();
}

void OpenDialogs::askForInputs(const QString& casePath, const QStringList& missing, bool areOptional)
{
    const QFileInfo file(casePath);
    auto* dialog = new ui::MissingInputs(file.fileName(), missing, file.absolutePath(), &ui_.dialogParent);
    dialog->offerOpenWithout(areOptional);
    connect(dialog, &ui::MissingInputs::openWithoutRequested, &openController_, &OpenController::openWithoutOptional);
    connect(dialog, &ui::MissingInputs::located, this, [this](const std::map<QString, QString>& places) {
        io::MovedInputs moved;
        for (const auto& [wanted, place] : places) {
            moved[wanted.toStdString()] = place.toStdString();
        }
        openController_.openWithInputs(moved);
    });
    connect(dialog, &ui::MissingInputs::searchRequested, this,
            [this](const QString& folder) { openController_.openWithInputs({}, folder); });
    dialog->open();
}

void OpenDialogs::openSample()
{
    if (files_.isBusy()) {
        return;
    }
    ui_.strip.showBusy(tr("Creating the sample case…"));
    files_.run(writeSampleCase, [this](const core::Result<QString>& path) {
        ui_.strip.showIdle(tr("Ready"));
        if (path) {
            openController_.open({path.value()});
        } else {
            notifications_.showProblem(tr("Could not create the sample case"), ui::messageText(path.error().message));
        }
    });
}

void OpenDialogs::confirmReplace()
{
    if (!saveController_.hasUnsavedWork()) {
        openController_.replaceOpenCase();
        return;
    }
    const bool isSavable = saveController_.savable() != SaveController::Savable::Nothing;
    const QString title = QString::fromStdString(document_.current().title);
    auto* question = new ui::QuestionDialog(
        {isSavable ? tr("Save the open case first?") : tr("Discard unsaved work?"),
         isSavable ? tr("“%1” has unsaved changes.").arg(title)
                   : tr("“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.").arg(title),
         {}},
        isSavable ? QStringList{tr("Save"), tr("Discard changes"), tr("Keep current case")}
                  : QStringList{tr("Keep current case"), tr("Discard changes")},
        &ui_.dialogParent);
    const int keep = isSavable ? 2 : 0;
    question->setAnswerOnClose(keep);
    connect(question, &ui::QuestionDialog::answered, this, [this, keep](int index) {
        if (index == keep) {
            openController_.abandon();
        } else if (index == 0) {
            saveController_.save([this] { confirmReplace(); });   // no further question if nothing remains unsaved
        } else {
            openController_.replaceOpenCase();
        }
    });
    question->open();
}

}   // namespace angiopose::app
