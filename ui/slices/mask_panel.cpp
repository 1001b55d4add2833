#include "ui/slices/mask_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace angiopose::ui {
namespace {

enum Tool { Paint, Erase, Cut };

}   // namespace

MaskPanel::MaskPanel(QWidget* parent)
    : QWidget(parent),
      opacity_(new QSlider(Qt::Horizontal)),
      tools_{makeModeButton([] { return tr("Paint"); }, Command::PaintMask),
             makeModeButton([] { return tr("Erase"); }, Command::EraseMask),
             makeModeButton([] { return tr("Scissors"); }, Command::CutMask)},
      radius_(new NumberField({0.2, 25.0, 1, QStringLiteral("mm"), 0.5})),
      ball_(withText(new QCheckBox, [] { return tr("3-D brush"); })),
      above_(withText(new QCheckBox, [] { return tr("Paint only above the threshold"); })),
      depth_(new QComboBox),
      range_(new NumberField({0.5, 500.0, 1, QStringLiteral("mm"), 1.0})),
      trace_(withText(new QPushButton, [] { return tr("Trace the mask"); })),
      save_(withText(new QPushButton, [] { return tr("Save mask…"); })),
      note_(roleLabel("hint"))
{
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 8, 0, 0);
    rows->setSpacing(6);
    rows->addWidget(withText(roleLabel("heading"), [] { return tr("Lumen mask"); }));
    rows->addLayout(opacityRow());
    rows->addLayout(toolRow());
    rows->addLayout(brushRows());
    rows->addLayout(cutRow());
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(trace_, 3);
    buttons->addWidget(save_, 2);
    withToolTip(trace_, [] {
        return tooltipWithShortcut(tr("Recreates the vessels from the current mask."), Command::TraceMask);
    });
    withToolTip(save_, [] { return tr("Writes the mask as a label image."); });
    rows->addLayout(buttons);
    note_->setWordWrap(true);
    rows->addWidget(note_);
    connectParts();
    keepTranslated(this, [this] {
        setItemTexts(*depth_, {tr("this slice"), tr("neighboring slices"), tr("all slices")});
        updateState();
    });
    showSettings({});
    showThreshold(false);
}

QLayout* MaskPanel::opacityRow()
{
    withAccessibleName(opacity_, [] { return tr("Mask over the slices"); });
    withToolTip(opacity_, [] { return tr("Sets the opacity of the mask over the slices."); });
    opacity_->setRange(0, 100);
    auto* row = new QHBoxLayout;
    row->addWidget(withText(roleLabel("label"), [] { return tr("Opacity"); }), 1);
    row->addWidget(opacity_, 2);
    return row;
}

QLayout* MaskPanel::toolRow()
{
    auto* row = new QHBoxLayout;
    for (QPushButton* tool : tools_) {
        row->addWidget(tool);
    }
    return row;
}

QLayout* MaskPanel::brushRows()
{
    withAccessibleName(radius_, [] { return tr("Radius of the brush"); });
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->addWidget(withText(roleLabel("label"), [] { return tr("Brush radius"); }), 1);
    row->addWidget(radius_, 1);
    rows->addLayout(row);
    rows->addWidget(ball_);
    rows->addWidget(above_);
    return rows;
}

QLayout* MaskPanel::cutRow()
{
    withAccessibleName(depth_, [] { return tr("Scissors depth"); });
    withAccessibleName(range_, [] { return tr("Depth on both sides of the slice"); });
    auto* row = new QHBoxLayout;
    row->addWidget(depth_, 3);
    row->addWidget(range_, 2);
    return row;
}

void MaskPanel::connectParts()
{
    connect(opacity_, &QSlider::valueChanged, this, &MaskPanel::edit);
    connect(radius_, &NumberField::edited, this, &MaskPanel::edit);
    connect(ball_, &QCheckBox::toggled, this, &MaskPanel::edit);
    connect(above_, &QCheckBox::toggled, this, &MaskPanel::edit);
    connect(depth_, &QComboBox::activated, this, &MaskPanel::edit);
    connect(range_, &NumberField::edited, this, &MaskPanel::edit);
}

void MaskPanel::bind(QAction& paint, QAction& erase, QAction& cut, QAction& trace, QAction& save)
{
    follow(*tools_[Paint], paint);
    follow(*tools_[Erase], erase);
    follow(*tools_[Cut], cut);
    follow(*trace_, trace);
    follow(*save_, save);
}

void MaskPanel::edit()
{
    settings_ = {opacity_->value() / 100.0,
                 radius_->value().value_or(settings_.radiusMm),
                 ball_->isChecked(),
                 above_->isChecked(),
                 static_cast<CutDepth>(depth_->currentIndex()),
                 range_->value().value_or(settings_.rangeMm)};
    range_->setVisible(settings_.depth == CutDepth::Range);
    emit settingsEdited(settings_);
}

void MaskPanel::showSettings(const MaskSettings& settings)
{
    settings_ = settings;
    const QSignalBlocker quietOpacity(opacity_);
    const QSignalBlocker quietBall(ball_);
    const QSignalBlocker quietAbove(above_);
    opacity_->setValue(static_cast<int>(std::lround(100.0 * settings.opacity)));
    radius_->showValue(settings.radiusMm);
    ball_->setChecked(settings.is3d);
    above_->setChecked(settings.isAboveThreshold);
    depth_->setCurrentIndex(static_cast<int>(settings.depth));
    range_->showValue(settings.rangeMm);
    range_->setVisible(settings.depth == CutDepth::Range);
}

void MaskPanel::showThreshold(bool hasThreshold)
{
    above_->setEnabled(hasThreshold);
}

void MaskPanel::showState(const MaskState& state)
{
    state_ = state;
    updateState();
}

void MaskPanel::updateState()
{
    const int open = state_.pendingStrokes;
    setRole(note_, open > 0 && !state_.isRunning ? "attention" : "hint");
    note_->setText(state_.isRunning ? tr("Tracing the mask…")
                   : open == 1      ? tr("1 mask change is not yet reflected in the vessels: trace the mask.")
                   : open > 1 ? tr("%1 mask changes are not yet reflected in the vessels: trace the mask.").arg(open)
                   : state_.isEdited ? tr("The vessels come from a manually edited mask.")
                                     : tr("Paint and cut, then trace the mask. Each stroke can be undone."));
}

}   // namespace angiopose::ui
