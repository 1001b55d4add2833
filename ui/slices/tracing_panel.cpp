#include "ui/slices/tracing_panel.h"

#include "ui/actions/action_button.h"
#include "ui/controls/number_field.h"
#include "ui/slices/label_choice.h"
#include "ui/slices/mask_panel.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int mostSeedRows = 4;   // seen at once
constexpr int leastWidth = 250;

QPushButton* switchButton(const Words& text, const Words& tip)
{
    auto* button = withTip(withText(new QPushButton, text), tip);
    button->setCheckable(true);
    return button;
}

QLayout* labelled(const Words& text, QWidget* field)
{
    auto* row = new QHBoxLayout;
    row->addWidget(withText(roleLabel("label"), text), 1);
    row->addWidget(field, 1);
    return row;
}

QString pointText(const QString& kind, const Eigen::Vector3d& point)
{
    return TracingPanel::tr("%1  %2  %3  %4")
        .arg(kind)
        .arg(numberText(point.x(), 1))
        .arg(numberText(point.y(), 1))
        .arg(numberText(point.z(), 1));
}

}   // namespace

TracingPanel::TracingPanel(QWidget* parent)
    : Section(
          "tracing", [] { return tr("Trace vessels"); }, Folding::Fixed, parent),
      labels_(new LabelChoice),
      mask_(new MaskPanel),
      thresholdBox_(new QWidget),
      automatic_(withText(new QCheckBox, [] { return tr("Automatic threshold"); })),
      threshold_(new NumberField({-32768.0, 65535.0, 0, QString(), 5.0})),
      slider_(new QSlider(Qt::Horizontal)),
      preview_(withText(new QCheckBox, [] { return tr("Show in the slices what is above"); })),
      seed_(switchButton(
          [] { return tr("Seeds"); },
          [] { return tr("Then click vessels in a slice: only what is connected to a seed is traced."); })),
      avoid_(switchButton([] { return tr("Avoid"); },
                          [] {
                              return tr(
                                  "Then click heart, veins or bone in a slice: what is reached from there on "
                                  "wider ways is left out.");
                          })),
      tubes_(withTip(withText(new QCheckBox, [] { return tr("Thin vessels only, from the seeds"); }),
                     [] {
                         return tr(
                             "For coronary arteries beside filled chambers, hepatic arteries beside the portal vein: "
                             "what is wider than a centimetre ends the vessels. Needs seeds.");
                     })),
      path_(modeButton([] { return tr("One vessel by two clicks"); }, Command::TraceBetween)),
      points_(new QListWidget),
      remove_(withText(new QPushButton, [] { return tr("Remove"); })),
      minLength_(new NumberField({0.0, 1000.0, 1, QStringLiteral("mm"), 1.0})),
      minRadius_(new NumberField({0.0, 1000.0, 2, QStringLiteral("mm"), 0.1})),
      pieces_(new QComboBox),
      keepLoops_(withText(new QCheckBox, [] { return tr("Keep loops"); })),
      trace_(withText(new QPushButton, [] { return tr("Trace"); })),
      stop_(withText(new QPushButton, [] { return tr("Stop"); })),
      note_(roleLabel("hint"))
{
    contentLayout()->setSpacing(8);
    auto* box = new QVBoxLayout(thresholdBox_);
    box->setContentsMargins(0, 0, 0, 0);
    box->addLayout(thresholdRows());
    contentLayout()->addWidget(labels_);
    contentLayout()->addWidget(thresholdBox_);
    contentLayout()->addLayout(pointRows());
    contentLayout()->addLayout(limitRows());
    contentLayout()->addLayout(shapeRows());
    contentLayout()->addLayout(buttonRow());
    note_->setWordWrap(true);
    contentLayout()->addWidget(note_);
    contentLayout()->addWidget(mask_);
    contentLayout()->addStretch(1);
    setMinimumWidth(leastWidth);
    showOptions({});
    showRange(std::nullopt, {});
    speak(this, [this] {
        fillPoints();
        updateButtons();
    });
}

QLayout* TracingPanel::thresholdRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(6);
    speak(threshold_, [this] { threshold_->setUnit(tr("HU")); });
    withName(slider_, [] { return tr("Threshold"); });
    withName(threshold_, [] { return tr("Threshold"); });
    withTip(threshold_, [] { return tr("The vessels begin at this value of the scan."); });
    rows->addWidget(automatic_);
    auto* row = new QHBoxLayout;
    row->addWidget(slider_, 2);
    row->addWidget(threshold_, 1);
    rows->addLayout(row);
    rows->addWidget(preview_);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool automatic) {
        setThreshold(automatic ? std::nullopt : std::optional(found_.value_or(threshold_->value().value_or(200.0))));
    });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { setThreshold(value); });
    connect(threshold_, &NumberField::edited, this, [this](double value) { setThreshold(value); });
    connect(preview_, &QCheckBox::toggled, this, &TracingPanel::previewChanged);
    return rows;
}

QLayout* TracingPanel::pointRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(6);
    auto* row = new QHBoxLayout;
    row->addWidget(seed_);
    row->addWidget(avoid_);
    row->addWidget(remove_);
    rows->addLayout(row);
    withName(points_, [] { return tr("Seeds and places to avoid"); });
    points_->setFrameShape(QFrame::NoFrame);
    points_->installEventFilter(this);
    rows->addWidget(points_);
    rows->addWidget(tubes_);
    rows->addWidget(path_);
    connect(tubes_, &QCheckBox::toggled, this, [this](bool on) {
        options_.tubesOnly = on;
        emit optionsEdited(options_);
    });
    connect(seed_, &QPushButton::toggled, this,
            [this](bool on) { emit pickWanted(on ? TracingPick::Seed : TracingPick::Nothing); });
    connect(avoid_, &QPushButton::toggled, this,
            [this](bool on) { emit pickWanted(on ? TracingPick::Avoid : TracingPick::Nothing); });
    connect(remove_, &QPushButton::clicked, this, &TracingPanel::removePoint);
    connect(points_, &QListWidget::currentRowChanged, this, [this](int chosen) {
        remove_->setEnabled(chosen >= 0 && !running_);
        const auto seeds = static_cast<int>(options_.seedsInPatient.size());
        if (chosen >= 0) {
            emit placeChosen(chosen < seeds ? options_.seedsInPatient[static_cast<std::size_t>(chosen)]
                                            : options_.avoidInPatient[static_cast<std::size_t>(chosen - seeds)]);
        }
    });
    return rows;
}

QLayout* TracingPanel::limitRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    withName(minLength_, [] { return tr("Shortest branch"); });
    withTip(minLength_, [] { return tr("Branches that leave their parent's wall by less are removed."); });
    withName(minRadius_, [] { return tr("Thinnest branch"); });
    withTip(minRadius_, [] { return tr("Branches whose mean radius is smaller are removed."); });
    rows->addLayout(labelled([] { return tr("Shortest branch"); }, minLength_));
    rows->addLayout(labelled([] { return tr("Thinnest branch"); }, minRadius_));
    connect(minLength_, &NumberField::edited, this, [this](double value) {
        options_.minBranchLengthMm = value;
        emit optionsEdited(options_);
    });
    connect(minRadius_, &NumberField::edited, this, [this](double value) {
        options_.minBranchRadiusMm = value;
        emit optionsEdited(options_);
    });
    return rows;
}

QLayout* TracingPanel::shapeRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    withName(pieces_, [] { return tr("Pieces"); });
    withTip(pieces_, [] {
        return tr(
            "Without seeds. As usual: all pieces of a mask, of a scan the great vessel's. All of a scan: those of "
            "every "
            "great vessel.");
    });
    speak(pieces_, [this] { setWords(*pieces_, {tr("As usual"), tr("All"), tr("The largest")}); });
    withTip(keepLoops_,
            [] { return tr("Vessels that run in a circle stay closed, else each is opened where it is thinnest."); });
    rows->addLayout(labelled([] { return tr("Pieces"); }, pieces_));
    rows->addWidget(keepLoops_);
    connect(pieces_, &QComboBox::activated, this, [this](int index) {
        options_.pieces = static_cast<core::TracedPieces>(index);
        emit optionsEdited(options_);
    });
    connect(keepLoops_, &QCheckBox::clicked, this, [this](bool isKept) {
        options_.loops = isKept ? core::VesselLoops::Kept : core::VesselLoops::Opened;
        emit optionsEdited(options_);
    });
    return rows;
}

QLayout* TracingPanel::buttonRow()
{
    auto* row = new QHBoxLayout;
    trace_->setProperty("role", "primary");
    withTip(stop_, [] { return tr("Ends the tracing; the vessels stay as they were."); });
    row->addWidget(trace_, 5);
    row->addWidget(stop_, 2);
    connect(trace_, &QPushButton::clicked, this, &TracingPanel::traceRequested);
    connect(stop_, &QPushButton::clicked, this, &TracingPanel::stopRequested);
    return row;
}

void TracingPanel::bindPath(QAction& action)
{
    follow(*path_, action);
}

void TracingPanel::showOptions(const core::VesselTracingOptions& options)
{
    const bool samePoints =
        options.seedsInPatient == options_.seedsInPatient && options.avoidInPatient == options_.avoidInPatient;
    options_ = options;
    const QSignalBlocker quietTubes(tubes_);
    tubes_->setChecked(options.tubesOnly);
    showThreshold();
    minLength_->showValue(options.minBranchLengthMm);
    minRadius_->showValue(options.minBranchRadiusMm);
    pieces_->setCurrentIndex(static_cast<int>(options.pieces));
    pieces_->setEnabled(options.seedsInPatient.empty());
    keepLoops_->setChecked(options.loops == core::VesselLoops::Kept);
    if (!samePoints || points_->count() == 0) {
        fillPoints();
    }
}

void TracingPanel::showRange(std::optional<std::pair<double, double>> range, const QString&)
{
    hasValues_ = range.has_value();
    thresholdBox_->setVisible(hasValues_);
    tubes_->setVisible(hasValues_);
    if (range) {
        const QSignalBlocker quiet(slider_);
        slider_->setRange(static_cast<int>(std::floor(range->first)), static_cast<int>(std::ceil(range->second)));
    }
    showThreshold();
}

void TracingPanel::showFound(std::optional<double> threshold)
{
    found_ = threshold;
    showThreshold();
    emit previewChanged();
}

void TracingPanel::showPick(TracingPick pick)
{
    const QSignalBlocker quietSeed(seed_);
    const QSignalBlocker quietAvoid(avoid_);
    seed_->setChecked(pick == TracingPick::Seed);
    avoid_->setChecked(pick == TracingPick::Avoid);
    updateButtons();
}

void TracingPanel::showWhyNot(const QString& reason)
{
    whyNot_ = reason;
    updateButtons();
}

void TracingPanel::setRunning(bool running)
{
    running_ = running;
    updateButtons();
}

bool TracingPanel::isPreviewWanted() const
{
    return preview_->isChecked() && hasValues_;
}

std::optional<double> TracingPanel::thresholdShown() const
{
    return options_.threshold ? options_.threshold : found_;
}

void TracingPanel::setThreshold(std::optional<double> threshold)
{
    if (threshold == options_.threshold) {
        return;
    }
    options_.threshold = threshold;
    showThreshold();
    preview_->setChecked(preview_->isChecked() || threshold);   // who moves it wants to see what it does
    emit optionsEdited(options_);
    emit previewChanged();
}

void TracingPanel::showThreshold()
{
    const QSignalBlocker quietBox(automatic_);
    const QSignalBlocker quietSlider(slider_);
    const auto shown = thresholdShown();
    automatic_->setChecked(!options_.threshold);
    threshold_->setEnabled(options_.threshold.has_value());
    slider_->setEnabled(options_.threshold.has_value());
    threshold_->showValue(shown);
    if (shown) {
        slider_->setValue(static_cast<int>(std::lround(*shown)));
    }
}

void TracingPanel::fillPoints()
{
    const QSignalBlocker quiet(points_);
    points_->clear();
    int number = 0;
    for (const Eigen::Vector3d& seed : options_.seedsInPatient) {
        points_->addItem(pointText(tr("+ seed %1").arg(++number), seed));
    }
    number = 0;
    for (const Eigen::Vector3d& point : options_.avoidInPatient) {
        points_->addItem(pointText(tr("× avoid %1").arg(++number), point));
    }
    points_->setVisible(points_->count() > 0);
    points_->setFixedHeight(std::min(points_->count(), mostSeedRows) * std::max(points_->sizeHintForRow(0), 1));
    remove_->setEnabled(false);
}

void TracingPanel::removePoint()
{
    const int row = points_->currentRow();
    const auto seeds = static_cast<int>(options_.seedsInPatient.size());
    if (row < 0 || running_) {
        return;
    }
    auto& points = row < seeds ? options_.seedsInPatient : options_.avoidInPatient;
    points.erase(points.begin() + (row < seeds ? row : row - seeds));
    fillPoints();
    emit optionsEdited(options_);
}

bool TracingPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched == points_ && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();   // not the branches' Delete
        if (event->type() == QEvent::KeyPress) {
            removePoint();
        }
        return true;
    }
    return Section::eventFilter(watched, event);
}

void TracingPanel::updateButtons()
{
    trace_->setEnabled(!running_ && whyNot_.isEmpty());
    trace_->setText(running_ ? tr("Tracing …") : tr("Trace"));
    stop_->setEnabled(running_);
    labels_->setRunning(running_);
    seed_->setEnabled(!running_);
    avoid_->setEnabled(!running_);
    remove_->setEnabled(!running_ && points_->currentRow() >= 0);
    const bool picks = seed_->isChecked() || avoid_->isChecked();
    note_->setText(!whyNot_.isEmpty() ? whyNot_
                   : picks            ? tr("Click in a slice to place a point; Esc ends.")
                                      : tr("The traced vessels replace the tree; undo brings it back."));
}

}   // namespace angiopose::ui