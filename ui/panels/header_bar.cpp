#include "ui/panels/header_bar.h"

#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace angiopose::ui {
namespace {

/// Styles the overflow button of the menu bar, since Qt's own icon suits only light windows.
void showOverflow(QMenuBar& menuBar)
{
    if (auto* extension = menuBar.findChild<QToolButton*>(QStringLiteral("qt_menubar_ext_button"))) {
        extension->setIcon({});
        extension->setToolButtonStyle(Qt::ToolButtonTextOnly);
        extension->setText(QStringLiteral("»"));
        withToolTip(extension, [] { return HeaderBar::tr("More menus"); });
    }
}

}   // namespace

HeaderBar::HeaderBar(QWidget* parent)
    : QWidget(parent), title_(new ElidedLabel("title")), study_(new ElidedLabel("label")), menuBar_(new QMenuBar)
{
    setProperty("role", "header");
    setAttribute(Qt::WA_StyledBackground);
    menuBar_->setNativeMenuBar(false);
    menuBar_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    showOverflow(*menuBar_);
    auto* notice = withText(roleLabel("attention"), [] { return tr("Not for clinical use"); });
    notice->setObjectName(QStringLiteral("clinicalNotice"));
    withToolTip(notice, [] { return tr("AngioPose is research software, not a medical device."); });

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 4, 14, 4);
    layout->setSpacing(16);
    layout->addWidget(menuBar_);
    layout->addWidget(title_);
    layout->addWidget(study_);
    layout->addStretch(1);
    layout->addWidget(notice);
}

void HeaderBar::showTitle(const QString& title)
{
    title_->showText(title);
}

void HeaderBar::showStudy(const QString& study)
{
    study_->showText(study);
}

}   // namespace angiopose::ui
