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

/// Which labels of a label image are traced. They are listed where the slices are large; the ticks are a draft until a
/// trace has taken them into the case.
class LabelController : public QObject {
    Q_OBJECT
public:
    LabelController(CaseDocument& document, ui::WindowActions& actions, ui::LabelChoice& choice, ui::SliceModel& slices,
                    QObject* parent = nullptr);

    /// What the next trace takes, as in core::VesselInput: empty for what the names say, or all.
    std::vector<int> draft() const;
    bool isNothingTicked() const { return overview_ && ticked_.empty(); }

signals:
    void edited();

private:
    void followDocument();
    void readIfWanted();
    void takeOverview(const LabelOverview& overview);
    void setDraft(const std::set<int>& labels);
    void showTicks();
    void takeTicksOfCase();

    CaseDocument& document_;
    ui::WindowActions& actions_;
    ui::LabelChoice& choice_;
    ui::SliceModel& slices_;
    LabelJob job_;
    core::InputFile shownFile_;   ///< the label image of the case; no path: it has none
    std::vector<int> shownLabels_;   ///< of the case
    std::optional<LabelOverview> overview_;
    std::set<int> ticked_;   ///< of the overview
    bool isEdited_ = false;   ///< they are not those of the case
};

}   // namespace angiopose::app