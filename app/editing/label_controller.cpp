#include "app/editing/label_controller.h"

#include "ui/actions/window_actions.h"
#include "ui/slices/label_choice.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/slices_page.h"
#include "ui/words/message_text.h"
#include "ui/words/retranslation.h"

namespace angiopose::app {
namespace {

constexpr double tickedOpacity = 0.75;
constexpr double otherOpacity = 0.2;

ui::LabelRow rowOf(const io::LabelInfo& label, std::size_t place)
{
    return {label.label, QString::fromStdString(label.name), label.volumeMl, ui::labelColor(place)};
}

}   // namespace

LabelController::LabelController(CaseDocument& document, ui::WindowActions& actions, ui::LabelChoice& choice,
                                 ui::SliceModel& slices, QObject* parent)
    : QObject(parent), document_(document), actions_(actions), choice_(choice), slices_(slices)
{
    QAction* large = actions[ui::Command::SlicesLarge];
    QAction* choose = actions[ui::Command::ChooseLabels];
    connect(&document, &CaseDocument::changed, this, &LabelController::updateFromDocument);
    connect(large, &QAction::toggled, this, &LabelController::readIfVisible);
    connect(choose, &QAction::triggered, this, [large, &choice] {
        large->setChecked(true);
        choice.focusList();
    });
    connect(&choice, &ui::LabelChoice::selectionEdited, this, &LabelController::setDraft);
    connect(&choice, &ui::LabelChoice::currentRowChanged, this, [this](int row) {
        const auto place = static_cast<std::size_t>(row);
        if (overview_ && place < overview_->centersInPatient.size()) {
            slices_.setCrosshair(overview_->centersInPatient[place]);
        }
    });
    connect(&job_, &LabelJob::finished, this, &LabelController::setOverview);
    connect(&job_, &LabelJob::failed, &choice,
            [&choice](const core::Message& reason) { choice.showProblem(ui::messageText(reason)); });
    ui::keepTranslated(this, [this] { showCheckedLabels(); });
    updateFromDocument();
}

std::vector<int> LabelController::draft() const
{
    return isEdited_ ? std::vector<int>(checked_.begin(), checked_.end()) : shownLabels_;
}

void LabelController::updateFromDocument()
{
    const core::Case& current = document_.current();
    const bool isLabels = current.vessels.input.kind == core::VesselInputKind::Segmentation;
    const core::InputFile file = isLabels ? current.vessels.file : core::InputFile();
    actions_[ui::Command::ChooseLabels]->setEnabled(!file.path.empty());
    if (file != shownFile_) {
        shownFile_ = file;
        job_.drop();
        overview_.reset();
        slices_.setLabels({});
        if (file.path.empty()) {
            choice_.showNothing();
        } else {
            choice_.showReading();
        }
        shownLabels_ = current.vessels.input.labels;
        isEdited_ = false;
        readIfVisible();
    } else if (current.vessels.input.labels != shownLabels_) {
        shownLabels_ = current.vessels.input.labels;
        checkLabelsOfCase();
    }
}

/// Reads the label image once the list is visible, since the image may be large.
void LabelController::readIfVisible()
{
    const bool isPanelVisible = actions_[ui::Command::SlicesLarge]->isChecked();
    if (isPanelVisible && !shownFile_.path.empty() && !overview_ && !job_.isRunning()) {
        job_.start(shownFile_.path);
    }
}

void LabelController::setOverview(const LabelOverview& overview)
{
    overview_ = overview;
    std::vector<ui::LabelRow> rows;
    for (const io::LabelInfo& label : overview.labels) {
        rows.push_back(rowOf(label, rows.size()));
    }
    choice_.showLabels(std::move(rows), overview.vessels);
    checkLabelsOfCase();
    emit edited();
}

/// Checks the labels stored in the case; if there are none, those named after vessels, otherwise all labels.
void LabelController::checkLabelsOfCase()
{
    isEdited_ = false;
    if (!overview_) {
        return;
    }
    checked_ = {shownLabels_.begin(), shownLabels_.end()};
    if (checked_.empty()) {
        checked_ = overview_->vessels;
    }
    for (const io::LabelInfo& label : overview_->labels) {
        if (shownLabels_.empty() && overview_->vessels.empty()) {
            checked_.insert(label.label);
        }
    }
    showCheckedLabels();
}

void LabelController::setDraft(const std::set<int>& labels)
{
    checked_ = labels;
    isEdited_ = true;
    showCheckedLabels();
    emit edited();
}

/// Shows the checked labels in the list and in the slices.
void LabelController::showCheckedLabels()
{
    if (!overview_) {
        return;
    }
    choice_.showChosenLabels(checked_);
    ui::LabelLayer layer{overview_->rows, {}, {}};
    for (const io::LabelInfo& label : overview_->labels) {
        const std::size_t place = layer.tints.size();
        const bool isTicked = checked_.contains(label.label);
        layer.tints.push_back({ui::labelColor(place), isTicked ? tickedOpacity : otherOpacity});
        layer.names << textOf(rowOf(label, place));
    }
    slices_.setLabels(std::move(layer));
}

}   // namespace angiopose::app
