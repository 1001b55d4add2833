#include "app/review/movie_controller.h"

#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "io/movie/movie_writer.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QFileInfo>

#include <cmath>
#include <utility>

namespace angiopose::app {

MovieController::MovieController(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      job_({[this](const QString& path) {
                parts_.strip.showIdle(tr("Ready"));
                parts_.notifications.showNote(tr("Saved: %1").arg(QFileInfo(path).fileName()));
                emit written(path);
            },
            [this](const core::Error& error) {
                parts_.strip.showIdle(tr("Ready"));
                if (error.isCancellation()) {
                    parts_.notifications.showNote(ui::messageText(error.message));
                } else {
                    parts_.notifications.showProblem(tr("Could not export"), ui::messageText(error.message));
                }
            },
            [this](double fraction) {
                parts_.strip.showProgress(tr("Writing the movie: %1 %").arg(ui::numberText(100.0 * fraction, 0)),
                                          fraction);
            }})
{
    connect(parts_.actions[ui::Command::ExportMovie], &QAction::triggered, this, &MovieController::openDialog);
    connect(&parts_.strip, &ui::BottomStrip::stopRequested, this, [this] { job_.requestStop(); });
}

void MovieController::openDialog()
{
    const core::Case& current = parts_.document.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        parts_.notifications.showNote(tr("Open vessels and an angiogram first."));
        return;
    }
    if (job_.isRunning() || parts_.document.isLocked()) {
        parts_.notifications.showNote(tr("Another task is running. Wait for it to finish."));
        return;
    }
    const auto& result = current.shown().result;
    ui::AvailableMovies available{current.shown().angiogram->frameCount() > 1, result && !result->history.empty(),
                                  [this](ui::MoviePart part) { return defaultFrameRate(part); },
                                  [this](const ui::MovieOptions& exportOptions) { return outcomeOf(exportOptions); }};
    auto* dialog = new ui::MovieDialog(std::move(available), &parts_.dialogParent);
    ui::MovieOptions usual;
    usual.format = settings::movieIsGif.read() ? ui::MovieFormat::Gif : ui::MovieFormat::Mp4;
    usual.widthPx = settings::movieWidthPx.read();
    usual.english = settings::exportEnglish.read() ? ui::Toggle::On : ui::Toggle::Off;
    usual.residualColors = settings::exportResiduals.read() ? ui::Toggle::On : ui::Toggle::Off;
    dialog->showOptions(usual);
    connect(dialog, &ui::MovieDialog::chosen, this, &MovieController::askForFile,
            Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    dialog->open();
}

void MovieController::askForFile(const ui::MovieOptions& exportOptions)
{
    const bool isGif = exportOptions.format == ui::MovieFormat::Gif;
    settings::movieIsGif.write(isGif);
    settings::movieWidthPx.write(exportOptions.widthPx);
    settings::exportEnglish.write(exportOptions.english == ui::Toggle::On);
    const ExportController::FileQuestion question{tr("Export movie"),
                                                  isGif ? tr("GIF movies (*.gif)") : tr("MP4 movies (*.mp4)"),
                                                  isGif ? QStringLiteral("gif") : QStringLiteral("mp4")};
    parts_.exportController.askForPath(question,
                                       [this, exportOptions](const QString& path) { start(exportOptions, path); });
}

void MovieController::start(const ui::MovieOptions& exportOptions, const QString& path)
{
    if (!parts_.document.current().vessels.tree || !parts_.document.current().shown().angiogram) {
        return;   // the case was closed or changed while the dialog was open
    }
    ui::OverlayExportOptions imageOptions;
    imageOptions.widthPx = exportOptions.widthPx;
    imageOptions.residualColors = exportOptions.residualColors;
    imageOptions.identity = exportOptions.identity;
    imageOptions.english = exportOptions.english;
    imageOptions.cutout = ui::Toggle::On;   // swipe and lens are drawn as in the window
    OverlayImageOptions options = parts_.exportController.overlayOptions(imageOptions);
    const auto target = parts_.target.current();
    parts_.strip.showBusy(tr("Writing the movie…"));
    job_.start([snapshot = caseForExport(parts_.document.current()), target, options, plan = makePlan(exportOptions),
                path](JobLink<double>& link) -> core::Result<QString> {
        const auto written = writeMovie(snapshot, target ? *target : core::Centerline2d{}, options, plan,
                                        path.toStdString(), [&link](double fraction) { return link.tell(fraction); });
        return written ? core::Result<QString>(path) : core::Result<QString>(written.error());
    });
}

MoviePlan MovieController::makePlan(const ui::MovieOptions& exportOptions) const
{
    MoviePlan plan;
    plan.content = static_cast<MovieContent>(exportOptions.part);
    plan.frames = parts_.cine.loop();
    plan.order = parts_.cine.order();
    plan.followed = parts_.follow.frames();
    plan.framesPerSecond = exportOptions.framesPerSecond;
    return plan;
}

double MovieController::defaultFrameRate(ui::MoviePart part) const
{
    const auto& run = parts_.document.current().shown().angiogram;
    switch (part) {
        case ui::MoviePart::Convergence:
            return convergenceFramesPerSecond;
        case ui::MoviePart::Rotation:
            return rotationFramesPerSecond;
        case ui::MoviePart::Run:
            break;
    }
    return run ? framesPerSecondOf(*run) * parts_.cine.speed() : rotationFramesPerSecond;
}

ui::AvailableMovies::Outcome MovieController::outcomeOf(const ui::MovieOptions& exportOptions) const
{
    const core::Case& current = parts_.document.current();
    const MoviePlan plan = makePlan(exportOptions);
    const MovieLength length = movieLength(current, plan);
    const int height = static_cast<int>(std::lround(exportOptions.widthPx * movieAspect(current, plan)));
    const auto kind = exportOptions.format == ui::MovieFormat::Gif ? io::MovieKind::Gif : io::MovieKind::Mp4;
    const auto problem = io::findProblem(kind, {exportOptions.widthPx, height});
    return {length.pictures,
            length.seconds,
            {exportOptions.widthPx, height},
            describePlan(plan),
            problem ? ui::messageText(*problem) : QString()};
}

QString MovieController::describePlan(const MoviePlan& plan) const
{
    if (plan.content != MovieContent::Run) {
        return {};
    }
    const QString frames =
        plan.order == core::CineOrder::BackAndForth ? tr("Frames %1 to %2, back and forth") : tr("Frames %1 to %2");
    return frames.arg(plan.frames.first + 1).arg(plan.frames.last + 1) + QStringLiteral(" · ") +
           (plan.followed.empty() ? tr("pose of this frame for all frames") : tr("tracked pose of each frame"));
}

}   // namespace angiopose::app
