#pragma once

#include "app/document/case_document.h"
#include "app/files/export_controller.h"
#include "app/jobs/job.h"
#include "app/review/tracking_controller.h"
#include "app/showing/cine_controller.h"
#include "app/showing/notifications.h"
#include "app/texts/movie.h"
#include "ui/dialogs/movie_dialog.h"

#include <QObject>

namespace angiopose::app {

/// Exports movies: asks for the content and writes the movie on a worker thread, with progress and a Stop button.
class MovieController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        CaseDocument& document;
        TargetProvider& target;
        ExportController& exportController;
        const TrackingController& follow;
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
    void openDialog();
    void askForFile(const ui::MovieOptions& exportOptions);
    void start(const ui::MovieOptions& exportOptions, const QString& path);
    MoviePlan makePlan(const ui::MovieOptions& exportOptions) const;
    double defaultFrameRate(ui::MoviePart part) const;
    ui::AvailableMovies::Outcome outcomeOf(const ui::MovieOptions& exportOptions) const;
    QString describePlan(const MoviePlan& plan) const;

    Parts parts_;
    Job<QString> job_;
};

}   // namespace angiopose::app
