#include "ui/panels/fault_bar.h"

#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {

FaultBar::FaultBar(QWidget* parent) : QWidget(parent), label_(roleLabel("label"))
{
    setObjectName(QStringLiteral("faultBar"));
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    label_->setWordWrap(true);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* bundle = withText(new QPushButton, [] { return tr("Save support bundle…"); });
    auto* close = withText(new QPushButton, [] { return tr("Dismiss"); });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 14, 6);
    layout->setSpacing(10);
    layout->addWidget(label_, 1);
    layout->addWidget(bundle);
    layout->addWidget(close);
    connect(bundle, &QPushButton::clicked, this, &FaultBar::bundleRequested);
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    hide();
    keepTranslated(this, [this] { updateText(); });
}

void FaultBar::showFault(const QString& dumpPath)
{
    dumpPath_ = dumpPath;
    updateText();
    show();
}

void FaultBar::updateText()
{
    label_->setText(tr("AngioPose crashed during its last session. A report of where in the program it crashed, "
                       "without case data, was saved to %1.")
                        .arg(dumpPath_));
}

}   // namespace angiopose::ui
