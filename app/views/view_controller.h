#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "app/registration/target_provider.h"
#include "app/views/view_summary.h"

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <vector>

class QPoint;
class QWidget;

namespace angiopose::ui {
class RegistrationPanel;
class ViewStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages several angiograms of the same vessels: the strip that shows the agreement of each view, selection of the
/// shown view, and removal. Showing another view is an undo step.
class ViewController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& panel;
        ui::RegistrationPanel& registration;
        QWidget& dialogParent;
    };
    ViewController(CaseDocument& document, const TargetProvider& target, const Ui& ui, QObject* parent = nullptr);

    bool isSummarizing() const { return summaryJob_.isRunning(); }   ///< true while computing summaries of the views
    /// Returns the traced vessels of a view; null until they have been computed (see `summariesReady`).
    std::shared_ptr<const core::Centerline2d> targetOf(std::size_t viewIndex) const;
    void show(int row);
    void showNext();
    void openMenu(int row, const QPoint& at);   ///< opens the menu of commands for this view
    void askForName(int row);
    void remove(int row);   ///< removes a view; if it was the shown view, shows the next one

signals:
    void refused(const QString& reason);
    void summariesReady();   ///< emitted when thumbnails and metrics are ready; see `targetOf`

private:
    /// Parts of a case on which the thumbnails and metrics depend.
    struct SummaryInputs {
        std::shared_ptr<const core::VesselTree> tree;
        std::vector<int> excluded;
        std::vector<int> hidden;
        std::vector<ViewKey> views;
        SharedCenterline target;

        bool operator==(const SummaryInputs&) const = default;
    };
    void connectWindow();
    void updateFromDocument();
    void showRows();
    void showThumbnails(std::vector<ViewSummary> summaries);
    void look();
    const ViewSummary* summaryOf(std::size_t viewIndex) const;

    CaseDocument& document_;
    const TargetProvider& target_;
    Ui ui_;
    std::size_t rowCount_ = 0;   ///< one line per view of the case, in order; 0 if there is only one view
    SummaryInputs summaryInputs_;
    std::vector<ViewSummary> summaries_;
    QTimer delayTimer_;   ///< delays the thumbnails until no further changes occur
    Job<std::vector<ViewSummary>> summaryJob_;
};

}   // namespace angiopose::app
