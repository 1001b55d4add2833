#pragma once

#include "app/document/case_document.h"
#include "app/jobs/label_job.h"

#include <QObject>

#include <set>

namespace angiopose::ui {
class LabelChoice;
class SliceModel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Lets the user select which labels of a label image to trace. The list is visible while the slices are enlarged; the
/// selection is a draft until a trace stores it in the case.
class LabelController : public QObject {
    Q_OBJECT
public:
    LabelController(CaseDocument& document, ui::WindowActions& actions, ui::LabelChoice& choice, ui::SliceModel& slices,
                    QObject* parent = nullptr);

    /// Labels for the next trace, as in core::VesselInput; if empty, the labels named after vessels, or all.
    std::vector<int> draft() const;
    bool isSelectionEmpty() const { return overview_ && checked_.empty(); }

signals:
    void edited();

private:
    void updateFromDocument();
    void readIfVisible();
    void setOverview(const LabelOverview& overview);
    void setDraft(const std::set<int>& labels);
    void showCheckedLabels();
    void checkLabelsOfCase();

    CaseDocument& document_;
    ui::WindowActions& actions_;
    ui::LabelChoice& choice_;
    ui::SliceModel& slices_;
    LabelJob job_;
    core::InputFile shownFile_;   ///< label image of the case; no path if there is none
    std::vector<int> shownLabels_;   ///< labels stored in the case
    std::optional<LabelOverview> overview_;
    std::set<int> checked_;   ///< labels checked in the list
    bool isEdited_ = false;   ///< true if the checked labels differ from those of the case
};

}   // namespace angiopose::app
