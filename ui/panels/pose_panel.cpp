#include "ui/panels/pose_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/panels/lock_button.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QGridLayout>
#include <QPushButton>

namespace angiopose::ui {
namespace {

NumberFormat formatOf(PoseAxis axis)
{
    if (isShift(axis)) {
        return {-2000.0, 2000.0, 2, QStringLiteral("mm"), 1.0, NumberSign::Always};
    }
    return {-180.0, 180.0, 2, QStringLiteral("°"), 1.0, NumberSign::Always};
}

}   // namespace

PosePanel::PosePanel(QWidget* parent)
    : Section(
          "pose", [] { return tr("Pose"); }, Folding::Fixed, parent)
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    for (const PoseAxis axis : poseAxes) {
        const Row row = makeRow(axis);
        const int line = static_cast<int>(axis);
        grid->addWidget(row.label, line, 0);
        grid->addWidget(row.field, line, 1);
        grid->addWidget(row.lock, line, 2);
        rows_[static_cast<std::size_t>(axis)] = row;
    }
    auto* reset = withText(new QPushButton, [] { return tr("Reset to initial pose"); });
    reset->setProperty("role", "quiet");
    withToolTip(reset, [] { return tooltipWithShortcut(tr("Undo restores the pose."), Command::ResetPose); });
    connect(reset, &QPushButton::clicked, this, &PosePanel::resetRequested);
    reset_ = reset;
    pivotNote_ = roleLabel("hint");
    pivotNote_->setWordWrap(true);
    pivotNote_->hide();
    keepTranslated(this, [this] {
        pivotNote_->setText(
            tr("Rotations and translations refer to the selected rotation center. %1 resets it to the centroid.")
                .arg(keyOf(Command::CentroidPivot)));
    });
    contentLayout()->addLayout(grid);
    contentLayout()->addWidget(pivotNote_);
    contentLayout()->addWidget(reset);
    keepTranslated(this, [this] { showNudgeMode(isNudging_); });
    showOffset(std::nullopt);
}

PosePanel::Row PosePanel::makeRow(PoseAxis axis)
{
    Row row{withText(roleLabel("label"), [this, axis] { return wordsOf(axis); }), new NumberField(formatOf(axis)),
            new LockButton};
    withAccessibleName(row.field, [axis] { return tr("Pose %1").arg(labelOf(axis)); });
    withToolTip(row.field, [axis] { return explanationOf(axis); });
    withToolTip(row.label, [axis] { return explanationOf(axis); });
    withAccessibleName(row.lock, [axis] { return tr("Lock %1").arg(labelOf(axis)); });
    withToolTip(row.lock,
                [] { return tr("Locks this value: nudging, dragging, typing and registration do not change it."); });
    row.label->setBuddy(row.field);
    connect(row.field, &NumberField::edited, this, [this, axis](double value) { editAxis(axis, value); });
    connect(row.lock, &QAbstractButton::clicked, this, [this, axis] { toggleLock(axis); });
    return row;
}

void PosePanel::showOffset(const std::optional<core::PoseOffset>& offset)
{
    offset_ = offset.value_or(core::PoseOffset{});
    reset_->setEnabled(offset.has_value());
    for (const PoseAxis axis : poseAxes) {
        const Row& row = rows_[static_cast<std::size_t>(axis)];
        row.field->setEnabled(offset.has_value());
        row.lock->setEnabled(offset.has_value());
        row.field->showValue(offset ? std::optional(valueOf(*offset, axis)) : std::nullopt);
    }
}

void PosePanel::showLocks(const PoseLocks& locks)
{
    locks_ = locks;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].lock->setChecked(locks[i]);
        rows_[i].field->setReadOnly(locks[i]);
        if (locks[i]) {   // clears the text selection in the locked field
            rows_[i].field->deselect();
        }
    }
    mark();
}

void PosePanel::showPickedPivot(bool isPicked)
{
    pivotNote_->setVisible(isPicked);
}

void PosePanel::showNudgeMode(bool on)
{
    isNudging_ = on;
    setHint(on ? tr("nudging · arrow keys · %1 to exit").arg(keyOf(Command::Nudge))
               : tr("%1: nudge (Ctrl fine, Shift coarse)").arg(keyOf(Command::Nudge)));
}

void PosePanel::setActiveAxis(std::optional<PoseAxis> axis)
{
    activeAxis_ = axis;
    mark();
}

void PosePanel::showDepthUncertainty(std::optional<double> depthSigmaMm)
{
    depthSigmaMm_ = depthSigmaMm;
    rows_[static_cast<std::size_t>(PoseAxis::AlongRay)].label->setText(wordsOf(PoseAxis::AlongRay));
    mark();
}

/// Returns the axis label, to which it appends a large depth uncertainty, e.g. "depth ±4".
QString PosePanel::wordsOf(PoseAxis axis) const
{
    return axis == PoseAxis::AlongRay && depthSigmaMm_
               ? tr("%1 ±%2").arg(labelOf(axis), numberText(*depthSigmaMm_, *depthSigmaMm_ < 9.95 ? 1 : 0))
               : labelOf(axis);
}

/// Shows the labels of locked axes, and that of depth if depth is poorly constrained, in amber.
void PosePanel::mark()
{
    for (const PoseAxis axis : poseAxes) {
        const bool isDoubtful = axis == PoseAxis::AlongRay && depthSigmaMm_;
        setRole(rows_[static_cast<std::size_t>(axis)].label, locks_[static_cast<std::size_t>(axis)] || isDoubtful
                                                                 ? "attention"
                                                             : activeAxis_ == axis ? "strong"
                                                                                   : "label");
    }
}

void PosePanel::editAxis(PoseAxis axis, double value)
{
    valueOf(offset_, axis) = value;
    emit offsetEdited(offset_);
}

void PosePanel::toggleLock(PoseAxis axis)
{
    PoseLocks newLocks = locks_;
    newLocks[static_cast<std::size_t>(axis)] = !newLocks[static_cast<std::size_t>(axis)];
    emit locksEdited(newLocks);
    showLocks(locks_);   // restores the current locks, since the owner may have rejected the edit
}

}   // namespace angiopose::ui
