#include "ui/panels/fault_bar.h"

#include "ui/controls/section.h"
#include "ui/words/spoken.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {

FaultBar::FaultBar(QWidget* parent) : QWidget(parent), words_(roleLabel("label"))
{
    setObjectName(QStringLiteral("faultBar"));
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    words_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* bundle = withText(new QPushButton, [] { return tr("Save support bundle…"); });
    auto* close = withText(new QPushButton, [] { return tr("Dismiss"); });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 14, 6);
    layout->setSpacing(10);
    layout->addWidget(words_, 1);
    layout->addWidget(bundle);
    layout->addWidget(close);
    connect(bundle, &QPushButton::clicked, this, &FaultBar::bundleRequested);
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    hide();
    speak(this, [this] { sayWhere(); });
}

void FaultBar::showFault(const QString& dumpPath)
{
    dumpPath_ = dumpPath;
    sayWhere();
    show();
}

void FaultBar::sayWhere()
{
    words_->setText(
        tr("AngioPose crashed last time. A report of where in the program it happened, without case data, is in %1.")
            .arg(dumpPath_));
}

}   // namespace angiopose::ui
