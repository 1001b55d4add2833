#include "ui/dialogs/study_browser.h"

#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"
#include "ui/dialogs/study_list.h"
#include "ui/words/language.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr QSize browserSize(1080, 720);
constexpr int damagedHeight = 90;

}   // namespace

StudyBrowser::StudyBrowser(const QString& place, QWidget* parent)
    : QDialog(parent),
      search_(new QLineEdit),
      list_(new StudyList),
      choice_(roleLabel("strong")),
      notes_(roleLabel("body")),
      progress_(new QProgressBar),
      status_(roleLabel("label")),
      stop_(new QPushButton(tr("Stop"))),
      damaged_(new QPushButton),
      offer_(roleLabel("label")),
      allFiles_(new QPushButton(tr("Also read them"))),
      damagedFiles_(new QPlainTextEdit),
      open_(new QPushButton(tr("Open")))
{
    setObjectName(QStringLiteral("studyBrowser"));
    setWindowTitle(tr("Studies in %1").arg(place));
    setAttribute(Qt::WA_DeleteOnClose);
    resizeWithinScreen(*this, browserSize);
    search_->setPlaceholderText(tr("Search by name, ID or description"));
    search_->setAccessibleName(tr("Search"));
    search_->setClearButtonEnabled(true);
    notes_->setWordWrap(true);
    notes_->setTextFormat(Qt::PlainText);
    choice_->setTextFormat(Qt::PlainText);
    choice_->setWordWrap(true);
    damagedFiles_->setReadOnly(true);
    damagedFiles_->setFixedHeight(damagedHeight);
    damagedFiles_->setAccessibleName(tr("Damaged files"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    layout->addWidget(notes_);
    layout->addLayout(makeStatus());
    layout->addWidget(damagedFiles_);
    layout->addLayout(makeButtons());

    connect(search_, &QLineEdit::textChanged, list_, &StudyList::search);
    connect(list_, &StudyList::thumbnailsRequested, this, &StudyBrowser::thumbnailsRequested);
    connect(list_, &StudyList::choiceChanged, this, &StudyBrowser::showSelection);
    connect(list_, &StudyList::currentItemChanged, this, &StudyBrowser::showSelection);
    connect(list_, &StudyList::openRequested, this, &StudyBrowser::acceptChoice);
    for (QWidget* each : {static_cast<QWidget*>(damaged_), static_cast<QWidget*>(offer_),
                          static_cast<QWidget*>(allFiles_), static_cast<QWidget*>(damagedFiles_)}) {
        each->hide();
    }
    showSelection();
    list_->setFocus();
}

QLayout* StudyBrowser::makeStatus()
{
    progress_->setTextVisible(false);
    progress_->setFixedSize(140, 6);
    damaged_->setProperty("role", "link");
    damaged_->setCheckable(true);
    allFiles_->setProperty("role", "link");
    auto* line = new QHBoxLayout;
    line->addWidget(progress_);
    line->addWidget(status_);
    line->addWidget(stop_);
    line->addWidget(damaged_);
    line->addStretch(1);
    line->addWidget(offer_);
    line->addWidget(allFiles_);
    for (QPushButton* each : {stop_, damaged_, allFiles_}) {
        each->setAutoDefault(false);
    }
    connect(stop_, &QPushButton::clicked, this, &StudyBrowser::stopRequested);
    connect(allFiles_, &QPushButton::clicked, this, &StudyBrowser::allFilesRequested);
    connect(damaged_, &QPushButton::toggled, damagedFiles_, &QWidget::setVisible);
    return line;
}

QLayout* StudyBrowser::makeButtons()
{
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setAutoDefault(false);
    open_->setProperty("role", "primary");
    open_->setDefault(true);
    auto* line = new QHBoxLayout;
    line->addWidget(choice_, 1);
    line->addWidget(cancel);
    line->addWidget(open_);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_, &QPushButton::clicked, this, &StudyBrowser::acceptChoice);
    return line;
}

void StudyBrowser::showRows(const std::vector<PatientRow>& patients)
{
    list_->showRows(patients);
}

void StudyBrowser::showThumbnail(const QString& key, const QImage& image)
{
    list_->showThumbnail(key, image);
}

void StudyBrowser::showProgress(qsizetype read, qsizetype total)
{
    const QLocale locale;
    isReading_ = true;
    progress_->show();
    stop_->show();
    offer_->hide();
    allFiles_->hide();
    damaged_->hide();
    damagedFiles_->hide();
    progress_->setRange(0, read > 0 ? static_cast<int>(total) : 0);   // duration unknown while folders are scanned
    progress_->setValue(static_cast<int>(read));
    status_->setText(read > 0 ? tr("%1 of %2 files").arg(locale.toString(read), locale.toString(total))
                              : tr("%1 files found").arg(locale.toString(total)));
}

void StudyBrowser::showEnd(const QString& summary, const QStringList& damaged, const QString& offer)
{
    isReading_ = false;
    progress_->hide();
    stop_->hide();
    status_->setText(summary);
    damaged_->setVisible(!damaged.isEmpty());
    damaged_->setText(tr("Damaged files: %1").arg(damaged.size()));
    damaged_->setChecked(false);
    damagedFiles_->setPlainText(damaged.join(u'\n'));
    offer_->setText(offer);
    offer_->setVisible(!offer.isEmpty());
    allFiles_->setVisible(!offer.isEmpty());
    showSelection();
}

void StudyBrowser::choose(const QString& key)
{
    list_->choose(key);
}

/// Shows a summary of the checked series and the notes of the current row.
void StudyBrowser::showSelection()
{
    const auto nameOf = [this](const QString& key) {
        const StudySeriesRow* row = list_->rowOf(key);
        return row ? row->description : QString();
    };
    QStringList views;
    for (const QString& key : list_->chosenViews()) {
        views << nameOf(key);
    }
    QStringList parts;
    if (!list_->chosenVessels().isEmpty()) {
        parts << tr("Vessels: %1").arg(nameOf(list_->chosenVessels()));
    }
    if (!views.isEmpty()) {
        parts << tr("Views: %1").arg(views.join(QStringLiteral(", ")));
    }
    const bool hasChoice = !parts.isEmpty();
    setRole(choice_, hasChoice ? "strong" : "hint");
    choice_->setText(hasChoice ? parts.join(QStringLiteral("   "))
                               : tr("Select the scan that shows the vessels and one or more angiographic runs, or "
                                    "double-click an entry to open it."));
    const StudySeriesRow* current = list_->currentRow();
    const bool hasNotes = current && !current->notes.isEmpty();
    notes_->setText(hasNotes ? QStringLiteral("%1: %2").arg(current->description, joinSentences(current->notes))
                             : QString());
    open_->setEnabled(!isReading_ && (hasChoice || (current && current->use != StudySeriesRow::Use::None)));
}

/// Emits the checked series or, if none is checked, the selected row. While files are still being read, a series may be
/// incomplete.
void StudyBrowser::acceptChoice()
{
    if (isReading_) {
        return;
    }
    if (list_->chosenVessels().isEmpty() && list_->chosenViews().isEmpty()) {
        if (const StudySeriesRow* current = list_->currentRow()) {
            list_->choose(current->key);
        }
    }
    if (list_->chosenVessels().isEmpty() && list_->chosenViews().isEmpty()) {
        return;
    }
    emit seriesChosen(list_->chosenVessels(), list_->chosenViews());
    accept();
}

void StudyBrowser::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Find)) {
        search_->setFocus();
        search_->selectAll();
    } else if (event->key() == Qt::Key_Down && search_->hasFocus()) {
        list_->setFocus();
    } else {
        QDialog::keyPressEvent(event);
    }
}

}   // namespace angiopose::ui
