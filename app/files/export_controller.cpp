#include "app/files/export_controller.h"

#include "app/files/pdf_picture.h"
#include "app/jobs/drr_job.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "app/texts/deformed_vessels.h"
#include "app/texts/image_file.h"
#include "app/words/snapshot_texts.h"
#include "app/words/view_words.h"
#include "core/case/registration_input.h"
#include "core/registration/deformable/deformed_tree.h"
#include "io/case_points.h"
#include "io/centerline2d_file.h"
#include "io/edited_mask.h"
#include "io/fiducial_file.h"
#include "io/measurement_table.h"
#include "io/motion_table.h"
#include "io/pose_camera_file.h"
#include "io/pose_file.h"
#include "io/results/result_file.h"
#include "io/support/atomic_file.h"
#include "io/target_point_table.h"
#include "io/vessel_tree_file.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/message_text.h"

#include <QFileDialog>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace angiopose::app {
namespace {

core::Status writePdf(const core::Case& session, const core::Centerline2d& target, const OverlayImageOptions& options,
                      const ImageFileOptions& file, const QString& path)
{
    const auto vectors = imageVectors(session, target, options, file);
    if (!vectors) {
        return vectors.error();
    }
    const QByteArray page = toPdf(vectors.value(), svgMetadata(session, file));
    return io::writeAtomically(path.toStdString(), {page.constData(), static_cast<std::size_t>(page.size())});
}

}   // namespace

ExportController::ExportController(CaseDocument& document, TargetProvider& target, const PosePreview& preview,
                                   ui::AngiogramView& view, QWidget& dialogParent, QObject* parent)
    : QObject(parent), document_(document), target_(target), preview_(preview), view_(view), dialogParent_(dialogParent)
{
}

void ExportController::askForFile(const FileQuestion& question, const Write& write, const Continuation& then)
{
    askForPath(question, [this, write, then, isOfCase = question.isOfCase](const QString& path) {
        run(path, write, then, isOfCase);
    });
}

void ExportController::askForPath(const FileQuestion& question, const std::function<void(const QString& path)>& use)
{
    const QString own = document_.path().isEmpty() ? QString::fromStdString(document_.current().title)
                                                   : QFileInfo(document_.path()).completeBaseName();
    const QString base = isPrivate() ? QStringLiteral("case") : own;
    const QString suggested = suggestedPath(document_.path(), base + QLatin1Char('.') + question.suffix);
    auto* dialog = new QFileDialog(&dialogParent_, question.title, suggested, question.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(question.suffix);
    connect(dialog, &QFileDialog::fileSelected, this, use);
    dialog->open();
}

void ExportController::writeFile(const QString& path, const Write& write, const Continuation& then)
{
    run(path, write, then, true);
}

void ExportController::run(const QString& path, const Write& write, const Continuation& then, bool isOfCase)
{
    emit started();
    files_.run(
        [path, write]() -> core::Result<QString> {
            if (const auto written = write(path); !written) {
                return written.error();
            }
            return path;
        },
        [this, then, isOfCase](const core::Result<QString>& outcome) {
            if (!outcome) {
                emit failed(ui::messageText(outcome.error().message));
                return;
            }
            rememberSaveFolder(outcome.value());
            emit written(outcome.value());
            if (isOfCase) {
                emit exported();
            }
            if (then) {
                then();
            }
        });
}

void ExportController::openOverlayDialog()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        emit failed(tr("There is nothing to export yet. Open a vessel tree and an angiogram first."));
        return;
    }
    ui::AngiogramView& view = view_;
    const core::Angiogram& run = *current.shown().angiogram;
    const auto viewWidth = static_cast<int>(std::lround(view.zoom() * run.width() * view.devicePixelRatioF()));
    auto* dialog =
        new ui::ExportDialog(std::max(64, viewWidth), static_cast<double>(run.height()) / run.width(), &dialogParent_);
    dialog->offerCutout(view.cutout() != ui::Cutout::Shape::None);
    const auto chosen = [](const Setting<bool>& setting) { return setting.read() ? ui::Toggle::On : ui::Toggle::Off; };
    ui::OverlayExportOptions usual{settings::exportWidthPx.read(), chosen(settings::exportResiduals), ui::Toggle::Off,
                                   chosen(settings::exportEnglish)};
    usual.format = static_cast<ui::ImageFileFormat>(std::clamp(settings::exportFormat.read(), 0, 2));
    usual.dotsPerInch = settings::exportDotsPerInch.read();
    dialog->showOptions(usual);
    const auto ask = [this](const ui::OverlayExportOptions& exportOptions) {
        settings::exportWidthPx.write(exportOptions.widthPx);
        settings::exportResiduals.write(exportOptions.residualColors == ui::Toggle::On);
        settings::exportEnglish.write(exportOptions.english == ui::Toggle::On);
        settings::exportDotsPerInch.write(exportOptions.dotsPerInch);
        if (exportOptions.part != ui::ImageContent::Frame16) {
            settings::exportFormat.write(static_cast<int>(exportOptions.format));
        }
        askForFile(questionFor(exportOptions.format), overlayWriter(exportOptions));
    };
    connect(dialog, &ui::ExportDialog::chosen, this, ask,
            Qt::QueuedConnection);   // queued: this dialog closes before another one opens
    dialog->open();
}

OverlayImageOptions ExportController::overlayOptions(const ui::OverlayExportOptions& exportOptions) const
{
    ui::AngiogramView& view = view_;
    const OverlayColoring coloring = preview_.isMotionColored() ? OverlayColoring::Motion : OverlayColoring::Residuals;
    OverlayImageOptions options{exportOptions.widthPx,
                                exportOptions.residualColors == ui::Toggle::On ? coloring : OverlayColoring::Branches,
                                exportOptions.identity == ui::Toggle::On ? Identity::Shown : Identity::Hidden,
                                exportOptions.english == ui::Toggle::On ? englishTexts : windowTexts};
    options.vessels = view.scene().mode();   // exports use the displayed vessel style
    options.range = view.shownRange();
    options.depthCue = view.scene().depthCue();
    options.shape = preview_.shape();
    options.cutout = exportOptions.cutout == ui::Toggle::On ? view.scene().cutout() : ui::Cutout{};
    options.isInitialPoseShown = exportOptions.initialPose == ui::Toggle::On;
    if (view.scene().hasDrr()) {
        const core::Centerline2d target = target_.current() ? *target_.current() : core::Centerline2d{};
        if (auto input = core::makeRegistrationInput(document_.current(), target)) {
            const auto source = std::make_shared<DrrSource>(std::move(input).value(), document_.current().options);
            options.drr = [source](const core::RigidTransform& pose) { return source->from(pose); };
        }
    }
    return options;
}

ExportController::FileQuestion ExportController::questionFor(ui::ImageFileFormat format)
{
    switch (format) {
        case ui::ImageFileFormat::Svg:
            return {tr("Export overlay"), tr("Vector graphics (*.svg)"), QStringLiteral("svg")};
        case ui::ImageFileFormat::Pdf:
            return {tr("Export overlay"), tr("PDF documents (*.pdf)"), QStringLiteral("pdf")};
        case ui::ImageFileFormat::Png:
            break;
    }
    return {tr("Export overlay"), tr("PNG images (*.png)"), QStringLiteral("png")};
}

ExportController::Write ExportController::overlayWriter(const ui::OverlayExportOptions& exportOptions) const
{
    const OverlayImageOptions options = overlayOptions(exportOptions);
    const ImageFileOptions file{static_cast<ImageFileContent>(exportOptions.part),
                                static_cast<double>(exportOptions.dotsPerInch)};
    return [snapshot = caseForExport(document_.current()), target = target_.current(), options,
            file](const QString& path) {
        const core::Centerline2d traced = target ? *target : core::Centerline2d{};
        return path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)
                   ? writePdf(snapshot, traced, options, file, path)
                   : writeImageFile(snapshot, traced, options, file, path.toStdString());
    };
}

void ExportController::exportOverlay(const ui::OverlayExportOptions& exportOptions, const QString& path)
{
    writeFile(path, overlayWriter(exportOptions));
}

void ExportController::askForResultFile()
{
    if (!document_.current().shown().result) {
        emit failed(tr("There is no result for this pose. Register first (R)."));
        return;
    }
    askForFile({tr("Export result"), tr("Results (*.json)"), QStringLiteral("result.json")},
               [snapshot = document_.current()](const QString& path) {
                   return io::writeResult(snapshot, path.toStdString());
               });
}

void ExportController::askForPoseFile()
{
    const core::View& shown = document_.current().shown();
    const auto camera = core::cameraOf(shown);
    const QString filters =
        tr("Poses (*.json *.tfm *.h5)") + QStringLiteral(";;") + tr("Poses with camera (*.txt *.yml *.xml)");
    askForFile({tr("Export pose"), camera ? filters : tr("Poses (*.json *.tfm *.h5)"), QStringLiteral("pose.json")},
               [pose = shown.cameraFromPatient, camera](const QString& path) {
                   const QString ending = QFileInfo(path).suffix().toLower();
                   const bool isBoth = ending == QStringLiteral("txt") || ending == QStringLiteral("yml") ||
                                       ending == QStringLiteral("yaml") || ending == QStringLiteral("xml");
                   return isBoth && camera ? io::writePosedCamera({camera.value(), pose}, path.toStdString())
                                           : io::writePose(pose, path.toStdString());
               });
}

void ExportController::askForTraceFile()
{
    if (!target_.current()) {
        emit failed(tr("No vessels have been traced in this frame yet."));
        return;
    }
    askForFile({tr("Export traced vessels"), tr("2-D centerlines (*.csv)"), QStringLiteral("csv")},
               [target = target_.current()](const QString& path) {
                   return io::writeCenterline2d(*target, path.toStdString());
               });
}

void ExportController::askForMeasurementFile()
{
    const auto isMeasured = [](const core::View& view) { return !view.measurements.empty(); };
    const core::Case& current = document_.current();
    if (current.vessels.measurements.empty() && std::ranges::none_of(current.views, isMeasured)) {
        emit failed(tr("Nothing has been measured yet."));
        return;
    }
    askForFile({tr("Export measurements"), tr("Tables (*.csv)"), QStringLiteral("measurements.csv")},
               [snapshot = document_.current()](const QString& path) {
                   return io::writeMeasurements(snapshot, path.toStdString());
               });
}

void ExportController::askForTargetPointFile()
{
    if (document_.current().vessels.marks.empty()) {
        emit failed(tr("No target points or rings have been set yet."));
        return;
    }
    const QString filters = tr("Tables (*.csv)") + QStringLiteral(";;") + tr("3D Slicer points (*.fcsv *.mrk.json)");
    askForFile({tr("Export target points"), filters, QStringLiteral("checkpoints.csv")},
               [snapshot = document_.current()](const QString& path) {
                   return path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive)
                              ? io::writeTargetPoints(snapshot, path.toStdString())
                              : io::writeFiducials(io::caseFiducials(snapshot), path.toStdString());
               });
}

void ExportController::askForDeformedFile()
{
    const core::Case& current = document_.current();
    const auto deformed = deformationForPose(current.shown(), current.vessels, current.shown().cameraFromPatient);
    if (!deformed) {
        emit failed(tr("There are no deformed vessels for this pose. Register first (R)."));
        return;
    }
    askForFile({tr("Export deformed vessels"),
                tr("Deformed centerlines (*.vtp)") + QStringLiteral(";;") + tr("Displacement of each point (*.csv)"),
                QStringLiteral("bent.vtp")},
               [tree = current.vessels.tree, deformed](const QString& path) -> core::Status {
                   return path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)
                              ? io::writeMotion(*tree, *deformed, path.toStdString())
                              : io::writeVesselTree(core::deformedTree(*tree, *deformed), path.toStdString());
               });
}

void ExportController::askForMaskFile()
{
    askForFile({tr("Export lumen mask"), tr("Label images (*.nrrd *.nii.gz *.nii *.mha)"), QStringLiteral("mask.nrrd")},
               [lumen = document_.current().vessels.lumen](const QString& path) -> core::Status {
                   return io::writeMask(*lumen, path.toStdString());
               });
}

void ExportController::askForVesselFile(const Continuation& then)
{
    if (!document_.current().vessels.tree) {
        emit failed(tr("There are no vessels yet. Open a centerline, or trace a scan."));
        return;
    }
    askForFile(
        {tr("Export vessel tree"), tr("Centerlines (*.vtp *.csv *.swc *.mrk.json)"), QStringLiteral("vtp")},
        [tree = document_.current().vessels.tree](const QString& path) {
            return io::writeVesselTree(*tree, path.toStdString());
        },
        then);
}

}   // namespace angiopose::app
