#include "ui/archive/cache_line.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace angiopose::ui {

CacheLine::CacheLine(QWidget* parent)
    : QWidget(parent),
      size_(roleLabel("label")),
      limit_(new NumberField({0.1, 100000.0, 1, QStringLiteral("GB"), 1.0})),
      empty_(new QPushButton(tr("Empty …")))
{
    size_->setObjectName(QStringLiteral("cacheSize"));
    limit_->setObjectName(QStringLiteral("cacheLimit"));
    limit_->setAccessibleName(tr("Most that the cache keeps"));
    limit_->setToolTip(tr("What was not used for the longest time is dropped first"));
    limit_->setFixedWidth(110);
    empty_->setAutoDefault(false);
    empty_->setToolTip(tr("Drop all that was retrieved"));
    auto* label = roleLabel("label", tr("of at most"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(size_);
    layout->addWidget(label);
    layout->addWidget(limit_);
    layout->addWidget(empty_);
    layout->addStretch(1);
    connect(limit_, &NumberField::edited, this, &CacheLine::limitChosen);
    connect(empty_, &QPushButton::clicked, this, &CacheLine::emptyRequested);
}

void CacheLine::showCache(const QString& size, bool isEmpty, double limitGb, const QString& folder)
{
    isEmpty_ = isEmpty;
    size_->setText(tr("Cache: %1").arg(size));
    size_->setToolTip(folder);
    limit_->showValue(limitGb);
    setBusy(false);
}

void CacheLine::setBusy(bool isBusy)
{
    empty_->setEnabled(!isBusy && !isEmpty_);
    limit_->setEnabled(!isBusy);
}

}   // namespace angiopose::ui
