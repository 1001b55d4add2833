#include "ui/archive/transfer_line.h"

#include "ui/controls/section.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace angiopose::ui {

TransferLine::TransferLine(QWidget* parent)
    : QWidget(parent), progress_(new QProgressBar), words_(roleLabel("hint")), stop_(new QPushButton(tr("Stop")))
{
    progress_->setTextVisible(false);
    progress_->setFixedSize(160, 6);
    progress_->setAccessibleName(tr("Progress"));
    words_->setObjectName(QStringLiteral("archiveWords"));
    words_->setWordWrap(true);
    words_->setTextFormat(Qt::PlainText);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    stop_->setAutoDefault(false);
    stop_->setToolTip(tr("Stops; complete objects are kept"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addWidget(progress_);
    layout->addWidget(words_, 1);
    layout->addWidget(stop_);
    setMinimumHeight(stop_->sizeHint().height());   // keeps the layout stable when Stop appears
    progress_->hide();
    stop_->hide();
    connect(stop_, &QPushButton::clicked, this, [this] {
        stop_->setEnabled(false);
        emit stopRequested();
    });
}

void TransferLine::showHint(const QString& words)
{
    show("hint", words, false);
}

void TransferLine::showBusy(const QString& words)
{
    show("label", words, true);
    progress_->setRange(0, 0);
}

void TransferLine::showProgress(const QString& words, qsizetype done, qsizetype all)
{
    show("label", words, true);
    progress_->setRange(0, static_cast<int>(all));
    progress_->setValue(static_cast<int>(std::min(done, all)));
}

void TransferLine::showDone(const QString& words)
{
    show("strong", words, false);
}

void TransferLine::showProblem(const QString& words)
{
    show("attention", words, false);
}

QString TransferLine::words() const
{
    return words_->text();
}

void TransferLine::show(const char* role, const QString& words, bool isBusy)
{
    setRole(words_, role);
    words_->setText(words);
    progress_->setVisible(isBusy);
    if (isBusy != isBusy_) {
        isBusy_ = isBusy;
        stop_->setEnabled(true);
        stop_->setVisible(isBusy);
        emit busyChanged(isBusy);
        QAccessibleEvent reported(words_, QAccessible::NameChanged);
        QAccessible::updateAccessibility(&reported);
    }
}

}   // namespace angiopose::ui
