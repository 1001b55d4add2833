#include "ui/slices/threshold_field.h"

#include "ui/controls/number_field.h"
#include "ui/words/spoken.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double usualHu = 200.0;   // where nothing was found

}   // namespace

ThresholdField::ThresholdField(QWidget* parent)
    : QWidget(parent),
      automatic_(withText(new QCheckBox, [] { return tr("Automatic threshold"); })),
      value_(new NumberField({-32768.0, 65535.0, 0, QString(), 5.0})),
      slider_(new QSlider(Qt::Horizontal)),
      preview_(withText(new QCheckBox, [] { return tr("Show in the slices what is above"); }))
{
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    rows->addWidget(automatic_);
    rows->addLayout(valueRow());
    rows->addWidget(preview_);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool automatic) {
        choose(automatic ? std::nullopt : std::optional(found_.value_or(value_->value().value_or(usualHu))));
    });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { choose(value); });
    connect(value_, &NumberField::edited, this, [this](double value) { choose(value); });
    connect(preview_, &QCheckBox::toggled, this, &ThresholdField::previewChanged);
    speak(value_, [this] { value_->setUnit(isHounsfield_ ? tr("HU") : QString()); });
}

QLayout* ThresholdField::valueRow()
{
    auto* row = new QHBoxLayout;
    withName(slider_, [] { return tr("Threshold"); });
    withName(value_, [] { return tr("Threshold"); });
    withTip(value_, [] { return tr("The vessels begin at this value of the scan."); });
    row->addWidget(slider_, 2);
    row->addWidget(value_, 1);
    return row;
}

void ThresholdField::showRange(std::pair<double, double> range, bool isHounsfield)
{
    const QSignalBlocker quiet(slider_);
    slider_->setRange(static_cast<int>(std::floor(range.first)), static_cast<int>(std::ceil(range.second)));
    isHounsfield_ = isHounsfield;
    value_->setUnit(isHounsfield ? tr("HU") : QString());
    showValues();
}

void ThresholdField::showChosen(std::optional<double> threshold)
{
    chosen_ = threshold;
    showValues();
}

void ThresholdField::showFound(std::optional<double> threshold)
{
    found_ = threshold;
    showValues();
    emit previewChanged();
}

bool ThresholdField::isPreviewWanted() const
{
    return preview_->isChecked();
}

std::optional<double> ThresholdField::shown() const
{
    return chosen_ ? chosen_ : found_;
}

void ThresholdField::choose(std::optional<double> threshold)
{
    if (threshold == chosen_) {
        return;
    }
    chosen_ = threshold;
    showValues();
    preview_->setChecked(preview_->isChecked() || threshold);   // who moves it wants to see what it does
    emit chosen(threshold);
    emit previewChanged();
}

void ThresholdField::showValues()
{
    const QSignalBlocker quietBox(automatic_);
    const QSignalBlocker quietSlider(slider_);
    automatic_->setChecked(!chosen_);
    value_->setEnabled(chosen_.has_value());
    slider_->setEnabled(chosen_.has_value());
    value_->showValue(shown());
    if (shown()) {
        slider_->setValue(static_cast<int>(std::lround(*shown())));
    }
}

}   // namespace angiopose::ui
