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
    ui::AvailableMovies offer{current.shown().angiogram->frameCount() > 1, result && !result->history.empty(),
                              [this](ui::MoviePart part) { return defaultFrameRate(part); },
                              [this](const ui::MovieOptions& choice) { return outcomeOf(choice); }};
    auto* dialog = new ui::MovieDialog(std::move(offer), &parts_.dialogParent);
    ui::MovieOptions usual;
    usual.format = settings::movieIsGif.read() ? ui::MovieFormat::Gif : ui::MovieFormat::Mp4;
    usual.widthPx = settings::movieWidthPx.read();
    usual.english = settings::exportEnglish.read() ? ui::Toggle::On : ui::Toggle::Off;
    usual.residualColors = settings::exportResiduals.read() ? ui::Toggle::On : ui::Toggle::Off;
    dialog->showChoice(usual);
    connect(dialog, &ui::MovieDialog::chosen, this, &MovieController::askFile,
            Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    dialog->open();
}

void MovieController::askFile(const ui::MovieOptions& choice)
{
    const bool isGif = choice.format == ui::MovieFormat::Gif;
    settings::movieIsGif.write(isGif);
    settings::movieWidthPx.write(choice.widthPx);
    settings::exportEnglish.write(choice.english == ui::Toggle::On);
    const ExportController::FileQuestion question{tr("Export movie"),
                                                  isGif ? tr("GIF movies (*.gif)") : tr("MP4 movies (*.mp4)"),
                                                  isGif ? QStringLiteral("gif") : QStringLiteral("mp4")};
    parts_.exporting.askPath(question, [this, choice](const QString& path) { start(choice, path); });
}

void MovieController::start(const ui::MovieOptions& choice, const QString& path)
{
    if (!parts_.document.current().vessels.tree || !parts_.document.current().shown().angiogram) {
        return;   // the case was closed or changed while the dialog was open
    }
    ui::OverlayExportOptions look;
    look.widthPx = choice.widthPx;
    look.residualColors = choice.residualColors;
    look.identity = choice.identity;
    look.english = choice.english;
    look.cutout = ui::Toggle::On;   // swipe and lens are drawn as in the window
    OverlayImageOptions options = parts_.exporting.overlayOptions(look);
    const auto target = parts_.target.current();
    parts_.strip.showBusy(tr("Writing the movie…"));
    job_.start([snapshot = caseForExport(parts_.document.current()), target, options, plan = makePlan(choice),
                path](JobLink<double>& link) -> core::Result<QString> {
        const auto written = writeMovie(snapshot, target ? *target : core::Centerline2d{}, options, plan,
                                        path.toStdString(), [&link](double fraction) { return link.tell(fraction); });
        return written ? core::Result<QString>(path) : core::Result<QString>(written.error());
    });
}

MoviePlan MovieController::makePlan(const ui::MovieOptions& choice) const
{
    MoviePlan plan;
    plan.content = static_cast<MovieContent>(choice.part);
    plan.frames = parts_.cine.loop();
    plan.order = parts_.cine.order();
    plan.followed = parts_.follow.frames();
    plan.framesPerSecond = choice.framesPerSecond;
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

ui::AvailableMovies::Outcome MovieController::outcomeOf(const ui::MovieOptions& choice) const
{
    const core::Case& current = parts_.document.current();
    const MoviePlan plan = makePlan(choice);
    const MovieLength length = lengthOf(current, plan);
    const int height = static_cast<int>(std::lround(choice.widthPx * aspectOf(current, plan)));
    const auto kind = choice.format == ui::MovieFormat::Gif ? io::MovieKind::Gif : io::MovieKind::Mp4;
    const auto problem = io::findProblem(kind, {choice.widthPx, height});
    return {length.imageCount,
            length.seconds,
            {choice.widthPx, height},
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
