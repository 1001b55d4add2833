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
      on_(parts),
      job_({[this](const QString& path) {
                on_.strip.showIdle(tr("Ready"));
                on_.notifications.showNote(tr("Saved: %1").arg(QFileInfo(path).fileName()));
                emit written(path);
            },
            [this](const core::Error& error) {
                on_.strip.showIdle(tr("Ready"));
                if (error.isStop()) {
                    on_.notifications.showNote(ui::messageText(error.message));
                } else {
                    on_.notifications.showProblem(tr("Could not export"), ui::messageText(error.message));
                }
            },
            [this](double fraction) {
                on_.strip.showProgress(tr("Writing the movie: %1 %").arg(ui::numberText(100.0 * fraction, 0)),
                                       fraction);
            }})
{
    connect(on_.actions[ui::Command::ExportMovie], &QAction::triggered, this, &MovieController::ask);
    connect(&on_.strip, &ui::BottomStrip::stopRequested, this, [this] { job_.requestStop(); });
}

void MovieController::ask()
{
    const core::Case& current = on_.document.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        on_.notifications.showNote(tr("Open vessels and an angiogram first."));
        return;
    }
    if (job_.isRunning() || on_.document.isLocked()) {
        on_.notifications.showNote(tr("Another task is running. Wait for it to finish."));
        return;
    }
    const auto& result = current.shown().result;
    ui::MovieOffer offer{current.shown().angiogram->frameCount() > 1, result && !result->history.empty(),
                         [this](ui::MoviePart part) { return usualPerSecond(part); },
                         [this](const ui::MovieChoice& choice) { return outcomeOf(choice); }};
    auto* dialog = new ui::MovieDialog(std::move(offer), &on_.dialogParent);
    ui::MovieChoice usual;
    usual.format = settings::movieIsGif.read() ? ui::MovieFormat::Gif : ui::MovieFormat::Mp4;
    usual.widthPx = settings::movieWidthPx.read();
    usual.english = settings::exportEnglish.read() ? ui::Choice::On : ui::Choice::Off;
    usual.residualColors = settings::exportResiduals.read() ? ui::Choice::On : ui::Choice::Off;
    dialog->showChoice(usual);
    connect(dialog, &ui::MovieDialog::chosen, this, &MovieController::askFile,
            Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    dialog->open();
}

void MovieController::askFile(const ui::MovieChoice& choice)
{
    const bool isGif = choice.format == ui::MovieFormat::Gif;
    settings::movieIsGif.write(isGif);
    settings::movieWidthPx.write(choice.widthPx);
    settings::exportEnglish.write(choice.english == ui::Choice::On);
    const ExportController::FileQuestion question{tr("Export movie"),
                                                  isGif ? tr("GIF movies (*.gif)") : tr("MP4 movies (*.mp4)"),
                                                  isGif ? QStringLiteral("gif") : QStringLiteral("mp4")};
    on_.exporting.askPath(question, [this, choice](const QString& path) { start(choice, path); });
}

void MovieController::start(const ui::MovieChoice& choice, const QString& path)
{
    if (!on_.document.current().vessels.tree || !on_.document.current().shown().angiogram) {
        return;   // the case was closed or changed while the dialog was open
    }
    ui::ExportChoice look;
    look.widthPx = choice.widthPx;
    look.residualColors = choice.residualColors;
    look.identity = choice.identity;
    look.english = choice.english;
    look.cutout = ui::Choice::On;   // swipe and lens are drawn as in the window
    OverlayPictureOptions options = on_.exporting.lookOf(look);
    const auto target = on_.target.current();
    on_.strip.showBusy(tr("Writing the movie…"));
    job_.start([snapshot = outgoingCase(on_.document.current()), target, options, plan = planOf(choice),
                path](JobLink<double>& link) -> core::Result<QString> {
        const auto written = writeMovie(snapshot, target ? *target : core::Centerline2d{}, options, plan,
                                        path.toStdString(), [&link](double fraction) { return link.tell(fraction); });
        return written ? core::Result<QString>(path) : core::Result<QString>(written.error());
    });
}

MoviePlan MovieController::planOf(const ui::MovieChoice& choice) const
{
    MoviePlan plan;
    plan.content = static_cast<MovieContent>(choice.part);
    plan.frames = on_.cine.loop();
    plan.order = on_.cine.order();
    plan.followed = on_.follow.frames();
    plan.framesPerSecond = choice.framesPerSecond;
    return plan;
}

double MovieController::usualPerSecond(ui::MoviePart part) const
{
    const auto& run = on_.document.current().shown().angiogram;
    switch (part) {
        case ui::MoviePart::Convergence:
            return convergencePerSecond;
        case ui::MoviePart::Turn:
            return turnPerSecond;
        case ui::MoviePart::Run:
            break;
    }
    return run ? framesPerSecondOf(*run) * on_.cine.speed() : turnPerSecond;
}

ui::MovieOffer::Outcome MovieController::outcomeOf(const ui::MovieChoice& choice) const
{
    const core::Case& current = on_.document.current();
    const MoviePlan plan = planOf(choice);
    const MovieLength length = lengthOf(current, plan);
    const int height = static_cast<int>(std::lround(choice.widthPx * aspectOf(current, plan)));
    const auto kind = choice.format == ui::MovieFormat::Gif ? io::MovieKind::Gif : io::MovieKind::Mp4;
    const auto problem = io::findProblem(kind, {choice.widthPx, height});
    return {length.pictures,
            length.seconds,
            {choice.widthPx, height},
            wordsOf(plan),
            problem ? ui::messageText(*problem) : QString()};
}

QString MovieController::wordsOf(const MoviePlan& plan) const
{
    if (plan.content != MovieContent::Run) {
        return {};
    }
    const QString frames =
        plan.order == core::CineOrder::BackAndForth ? tr("Frames %1 to %2, back and forth") : tr("Frames %1 to %2");
    return frames.arg(plan.frames.first + 1).arg(plan.frames.last + 1) + QStringLiteral(" · ") +
           (plan.followed.empty() ? tr("pose of this frame for all") : tr("each with its tracked pose"));
}

}   // namespace angiopose::app
