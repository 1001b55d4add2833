#include "ui/slices/seed_list.h"

#include "ui/controls/number_field.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int maxRows = 4;   // maximum number of visible rows

QPushButton* makeToggleButton(const LocalizedText& text, const LocalizedText& tip)
{
    auto* button = withToolTip(withText(new QPushButton, text), tip);
    button->setCheckable(true);
    return button;
}

QString pointText(const QString& kind, const Eigen::Vector3d& point)
{
    return SeedList::tr("%1  %2  %3  %4")
        .arg(kind)
        .arg(numberText(point.x(), 1))
        .arg(numberText(point.y(), 1))
        .arg(numberText(point.z(), 1));
}

constexpr double typicalHu = 200.0;   // HU; initial manual threshold if there is no automatic one

}   // namespace

SeedList::SeedList(QWidget* parent)
    : QWidget(parent),
      pickSeed_(makeToggleButton(
          [] { return tr("Seeds"); },
          [] { return tr("Click vessels in a slice. Only vessels connected to a seed are traced."); })),
      pickAvoid_(makeToggleButton([] { return tr("Avoid"); },
                                  [] {
                                      return tr(
                                          "Click the heart, veins or bone in a slice. Regions with a wider connection "
                                          "to these points than to the seeds are excluded.");
                                  })),
      remove_(withText(new QPushButton, [] { return tr("Remove"); })),
      points_(new QListWidget)
{
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    rows->addLayout(buttonRow());
    withAccessibleName(points_, [] { return tr("Seeds and points to avoid"); });
    points_->setFrameShape(QFrame::NoFrame);
    points_->installEventFilter(this);
    rows->addWidget(points_);
    connect(points_, &QListWidget::currentRowChanged, this, &SeedList::choose);
    keepTranslated(this, [this] { fill(); });
}

QLayout* SeedList::buttonRow()
{
    auto* row = new QHBoxLayout;
    row->addWidget(pickSeed_);
    row->addWidget(pickAvoid_);
    row->addWidget(remove_);
    connect(pickSeed_, &QPushButton::toggled, this,
            [this](bool on) { emit pickRequested(on ? TracingPick::Seed : TracingPick::Nothing); });
    connect(pickAvoid_, &QPushButton::toggled, this,
            [this](bool on) { emit pickRequested(on ? TracingPick::Avoid : TracingPick::Nothing); });
    connect(remove_, &QPushButton::clicked, this, &SeedList::removeSelected);
    return row;
}

void SeedList::showPoints(const Points& seedsInPatient, const Points& avoidInPatient)
{
    if (seedsInPatient == seeds_ && avoidInPatient == avoid_) {
        return;
    }
    seeds_ = seedsInPatient;
    avoid_ = avoidInPatient;
    fill();
}

void SeedList::showPick(TracingPick pick)
{
    const QSignalBlocker quietSeed(pickSeed_);
    const QSignalBlocker quietAvoid(pickAvoid_);
    pickSeed_->setChecked(pick == TracingPick::Seed);
    pickAvoid_->setChecked(pick == TracingPick::Avoid);
}

void SeedList::setRunning(bool running)
{
    running_ = running;
    pickSeed_->setEnabled(!running);
    pickAvoid_->setEnabled(!running);
    remove_->setEnabled(!running && points_->currentRow() >= 0);
}

bool SeedList::isPicking() const
{
    return pickSeed_->isChecked() || pickAvoid_->isChecked();
}

void SeedList::fill()
{
    const QSignalBlocker quiet(points_);
    points_->clear();
    int number = 0;
    for (const Eigen::Vector3d& seed : seeds_) {
        points_->addItem(pointText(tr("+ seed %1").arg(++number), seed));
    }
    number = 0;
    for (const Eigen::Vector3d& point : avoid_) {
        points_->addItem(pointText(tr("× avoid %1").arg(++number), point));
    }
    points_->setVisible(points_->count() > 0);
    points_->setFixedHeight(std::min(points_->count(), maxRows) * std::max(points_->sizeHintForRow(0), 1));
    remove_->setEnabled(false);
}

SeedList::Points& SeedList::listOf(int& row)
{
    const auto seeds = static_cast<int>(seeds_.size());
    if (row < seeds) {
        return seeds_;
    }
    row -= seeds;
    return avoid_;
}

void SeedList::choose(int row)
{
    remove_->setEnabled(row >= 0 && !running_);
    if (row >= 0) {
        const Points& points = listOf(row);
        emit pointSelected(points[static_cast<std::size_t>(row)]);
    }
}

void SeedList::removeSelected()
{
    int row = points_->currentRow();
    if (row < 0 || running_) {
        return;
    }
    Points& points = listOf(row);
    points.erase(points.begin() + row);
    fill();
    emit edited(seeds_, avoid_);
}

bool SeedList::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched == points_ && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();   // keeps the window shortcut from deleting branches
        if (event->type() == QEvent::KeyPress) {
            removeSelected();
        }
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

ThresholdField::ThresholdField(QWidget* parent)
    : QWidget(parent),
      automatic_(withText(new QCheckBox, [] { return tr("Automatic threshold"); })),
      value_(new NumberField({-32768.0, 65535.0, 0, QString(), 5.0})),
      slider_(new QSlider(Qt::Horizontal)),
      preview_(withText(new QCheckBox, [] { return tr("Preview threshold"); }))
{
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    rows->addWidget(automatic_);
    rows->addLayout(valueRow());
    rows->addWidget(preview_);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool automatic) {
        choose(automatic ? std::nullopt
                         : std::optional(automaticThreshold_.value_or(value_->value().value_or(typicalHu))));
    });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { choose(value); });
    connect(value_, &NumberField::edited, this, [this](double value) { choose(value); });
    connect(preview_, &QCheckBox::toggled, this, &ThresholdField::previewChanged);
    keepTranslated(value_, [this] { value_->setUnit(isHounsfield_ ? tr("HU") : QString()); });
}

QLayout* ThresholdField::valueRow()
{
    auto* row = new QHBoxLayout;
    withAccessibleName(slider_, [] { return tr("Threshold"); });
    withAccessibleName(value_, [] { return tr("Threshold"); });
    withToolTip(value_, [] { return tr("Voxels above this scan intensity are treated as vessel lumen."); });
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

void ThresholdField::showManual(std::optional<double> threshold)
{
    manualThreshold_ = threshold;
    showValues();
}

void ThresholdField::showAutomatic(std::optional<double> threshold)
{
    automaticThreshold_ = threshold;
    showValues();
    emit previewChanged();
}

bool ThresholdField::isPreviewWanted() const
{
    return preview_->isChecked();
}

std::optional<double> ThresholdField::shown() const
{
    return manualThreshold_ ? manualThreshold_ : automaticThreshold_;
}

void ThresholdField::choose(std::optional<double> threshold)
{
    if (threshold == manualThreshold_) {
        return;
    }
    manualThreshold_ = threshold;
    showValues();
    preview_->setChecked(preview_->isChecked() || threshold);   // entering a threshold turns the preview on
    emit thresholdChosen(threshold);
    emit previewChanged();
}

void ThresholdField::showValues()
{
    const QSignalBlocker quietBox(automatic_);
    const QSignalBlocker quietSlider(slider_);
    automatic_->setChecked(!manualThreshold_);
    value_->setEnabled(manualThreshold_.has_value());
    slider_->setEnabled(manualThreshold_.has_value());
    value_->showValue(shown());
    if (shown()) {
        slider_->setValue(static_cast<int>(std::lround(*shown())));
    }
}

}   // namespace angiopose::ui
