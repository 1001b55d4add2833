#include "ui/dialogs/movie_dialog.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"
#include "ui/words/language.h"
#include "ui/words/number.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double minFrameRate = 0.5, fastest = 100.0;

}   // namespace

MovieDialog::MovieDialog(AvailableMovies available, QWidget* parent)
    : QDialog(parent),
      availableMovies_(std::move(available)),
      part_(new QComboBox),
      format_(new QComboBox),
      width_(new NumberField({64.0, 8192.0, 0, QStringLiteral("px"), 64.0})),
      rate_(new NumberField({minFrameRate, fastest, 1, tr("frames per second"), 1.0})),
      outcome_(roleLabel("hint")),
      residuals_(new QCheckBox(tr("Residual colors with scale"))),
      identity_(new QCheckBox(tr("Burn in patient identity"))),
      english_(new QCheckBox(tr("English labels"))),
      export_(new QPushButton(tr("Export…")))
{
    setObjectName(QStringLiteral("movieDialog"));
    setWindowTitle(tr("Export movie"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(440);
    part_->setObjectName(QStringLiteral("moviePart"));
    format_->setObjectName(QStringLiteral("movieFormat"));
    rate_->setObjectName(QStringLiteral("movieRate"));
    outcome_->setObjectName(QStringLiteral("movieOutcome"));
    outcome_->setWordWrap(true);
    fillParts();
    format_->addItems({tr("MP4, for players and slides"), tr("GIF, for web pages; loops automatically")});
    auto* notice = roleLabel("hint", tr("Each frame is labeled “Not for clinical use” and shows the origin of its pose "
                                        "and whether the pose is reliable."));
    notice->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(14);
    layout->addLayout(makeForm());
    layout->addWidget(notice);
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *export_));
    connect(part_, &QComboBox::currentIndexChanged, this, &MovieDialog::showDefaultRate);
    connect(format_, &QComboBox::currentIndexChanged, this, &MovieDialog::showOutcome);
    connect(width_, &NumberField::edited, this, &MovieDialog::showOutcome);
    connect(rate_, &NumberField::edited, this, &MovieDialog::showOutcome);
    connect(this, &QDialog::accepted, this, [this] { emit chosen(exportOptions()); });
    showOptions({});
    showDefaultRate();
}

void MovieDialog::fillParts()
{
    if (availableMovies_.hasRun) {
        part_->addItem(tr("Overlay through the run"), static_cast<int>(MoviePart::Run));
    }
    if (availableMovies_.hasConvergence) {
        part_->addItem(tr("Convergence of the registration"), static_cast<int>(MoviePart::Convergence));
    }
    part_->addItem(tr("Vessels only, one full rotation"), static_cast<int>(MoviePart::Rotation));
}

QFormLayout* MovieDialog::makeForm()
{
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->addRow(roleLabel("label", tr("Movie")), part_);
    form->addRow(roleLabel("label", tr("Format")), format_);
    form->addRow(roleLabel("label", tr("Width")), width_);
    form->addRow(roleLabel("label", tr("Speed")), rate_);
    for (QWidget* line : std::initializer_list<QWidget*>{outcome_, residuals_, identity_, english_}) {
        form->addRow(QString(), line);
    }
    english_->setVisible(currentLanguage() != languages().front());
    return form;
}

void MovieDialog::showOptions(const MovieOptions& exportOptions)
{
    const int part = part_->findData(static_cast<int>(exportOptions.part));
    part_->setCurrentIndex(part < 0 ? 0 : part);
    format_->setCurrentIndex(static_cast<int>(exportOptions.format));
    width_->showValue(exportOptions.widthPx);
    residuals_->setChecked(exportOptions.residualColors == Toggle::On);
    identity_->setChecked(exportOptions.identity == Toggle::On);
    english_->setChecked(exportOptions.english == Toggle::On);
    showOutcome();
}

MovieOptions MovieDialog::exportOptions() const
{
    MovieOptions result;
    result.part = static_cast<MoviePart>(part_->currentData().toInt());
    result.format = static_cast<MovieFormat>(format_->currentIndex());
    result.widthPx = static_cast<int>(width_->value().value_or(1024.0));
    result.framesPerSecond = rate_->value().value_or(availableMovies_.defaultFrameRate(result.part));
    result.identity = identity_->isChecked() ? Toggle::On : Toggle::Off;
    result.english = english_->isChecked() ? Toggle::On : Toggle::Off;
    result.residualColors = residuals_->isChecked() ? Toggle::On : Toggle::Off;
    return result;
}

void MovieDialog::showDefaultRate()
{
    rate_->showValue(std::clamp(availableMovies_.defaultFrameRate(exportOptions().part), minFrameRate, fastest));
    showOutcome();
}

void MovieDialog::showOutcome()
{
    const MovieOptions options = exportOptions();
    residuals_->setVisible(options.part == MoviePart::Convergence);
    const AvailableMovies::Outcome outcome = availableMovies_.outcomeOf(options);
    const QString length = tr("%1 frames, %2 s, %3 × %4 px")
                               .arg(outcome.imageCount)
                               .arg(numberText(outcome.seconds, 1))
                               .arg(outcome.size.width())
                               .arg(outcome.size.height());
    const QString reported = outcome.description.isEmpty() ? length : length + QLatin1Char('\n') + outcome.description;
    outcome_->setText(outcome.problem.isEmpty() ? reported : outcome.problem);
    export_->setEnabled(outcome.problem.isEmpty());
}

}   // namespace angiopose::ui
