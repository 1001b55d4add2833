#include "ui/views/scan_bar.h"

#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int steps = 100;

}   // namespace

ScanBar::ScanBar(QWidget* parent)
    : QWidget(parent), choice_(new QToolButton), menu_(new QMenu(this)), strength_(new QSlider(Qt::Horizontal))
{
    choice_->setProperty("role", "tab");
    choice_->setPopupMode(QToolButton::InstantPopup);
    choice_->setMenu(menu_);
    withToolTip(choice_, [] { return tr("Display of the scan behind the vessels"); });
    strength_->setRange(0, steps);
    strength_->setMinimumWidth(50);
    strength_->setMaximumWidth(160);
    withAccessibleName(strength_, [] { return tr("Opacity of the scan"); });
    withToolTip(strength_, [] { return tr("Opacity of the scan"); });
    connect(strength_, &QSlider::valueChanged, this,
            [this](int value) { emit strengthChanged(static_cast<double>(value) / steps); });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 3);
    layout->setSpacing(8);
    layout->addWidget(choice_);
    layout->addStretch(1);
    layout->addWidget(strength_, 2);
}

void ScanBar::fillMenu(const QList<QAction*>& actions)
{
    menu_->addActions(actions);
}

void ScanBar::showState(const QString& text, bool isShown)
{
    choice_->setText(text + QStringLiteral(" ▾"));
    choice_->setAccessibleName(text);
    strength_->setVisible(isShown);
}

void ScanBar::showStrength(double strength)
{
    const QSignalBlocker silence(strength_);
    strength_->setValue(static_cast<int>(std::lround(steps * strength)));
}

}   // namespace angiopose::ui
