#pragma once

#include "app/document/case_document.h"
#include "app/files/export_controller.h"
#include "app/jobs/job.h"
#include "app/review/follow_controller.h"
#include "app/showing/cine_controller.h"
#include "app/showing/notifications.h"
#include "app/texts/movie.h"
#include "ui/dialogs/movie_dialog.h"

#include <QObject>

namespace angiopose::app {

/// Exports movies: asks for the content and writes it on a worker thread, with progress and a Stop button.
class MovieController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        CaseDocument& document;
        TargetProvider& target;
        ExportController& exporting;
        const FollowController& follow;
        const CineController& cine;
        Notifications& notifications;
        ui::WindowActions& actions;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    explicit MovieController(const Parts& parts, QObject* parent = nullptr);

    bool isRunning() const { return job_.isRunning(); }

signals:
    void written(const QString& path);

private:
    void ask();
    void askFile(const ui::MovieChoice& choice);
    void start(const ui::MovieChoice& choice, const QString& path);
    MoviePlan planOf(const ui::MovieChoice& choice) const;
    double usualPerSecond(ui::MoviePart part) const;
    ui::MovieOffer::Outcome outcomeOf(const ui::MovieChoice& choice) const;
    QString wordsOf(const MoviePlan& plan) const;

    Parts on_;
    Job<QString> job_;
};

}   // namespace angiopose::app
