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
    : QWidget(parent), progress_(new QProgressBar), label_(roleLabel("hint")), stop_(new QPushButton(tr("Stop")))
{
    progress_->setTextVisible(false);
    progress_->setFixedSize(160, 6);
    progress_->setAccessibleName(tr("Progress"));
    label_->setObjectName(QStringLiteral("archiveWords"));
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    stop_->setAutoDefault(false);
    stop_->setToolTip(tr("Stops the transfer; objects already transferred in full are kept"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addWidget(progress_);
    layout->addWidget(label_, 1);
    layout->addWidget(stop_);
    setMinimumHeight(stop_->sizeHint().height());   // keeps the layout stable when Stop appears
    progress_->hide();
    stop_->hide();
    connect(stop_, &QPushButton::clicked, this, [this] {
        stop_->setEnabled(false);
        emit stopRequested();
    });
}

void TransferLine::showHint(const QString& statusText)
{
    show("hint", statusText, false);
}

void TransferLine::showBusy(const QString& statusText)
{
    show("label", statusText, true);
    progress_->setRange(0, 0);
}

void TransferLine::showProgress(const QString& statusText, qsizetype done, qsizetype all)
{
    show("label", statusText, true);
    progress_->setRange(0, static_cast<int>(all));
    progress_->setValue(static_cast<int>(std::min(done, all)));
}

void TransferLine::showDone(const QString& statusText)
{
    show("strong", statusText, false);
}

void TransferLine::showProblem(const QString& statusText)
{
    show("attention", statusText, false);
}

QString TransferLine::statusText() const
{
    return label_->text();
}

void TransferLine::show(const char* role, const QString& statusText, bool isBusy)
{
    setRole(label_, role);
    label_->setText(statusText);
    progress_->setVisible(isBusy);
    if (isBusy != isBusy_) {
        isBusy_ = isBusy;
        stop_->setEnabled(true);
        stop_->setVisible(isBusy);
        emit busyChanged(isBusy);
        QAccessibleEvent reported(label_, QAccessible::NameChanged);
        QAccessible::updateAccessibility(&reported);
    }
}

}   // namespace angiopose::ui
