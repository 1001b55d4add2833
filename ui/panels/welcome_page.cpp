#include "ui/panels/welcome_page.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int welcomeSideMargin = 16;

}   // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent), recent_(new RecentList), page_(new QWidget), buttons_(new QBoxLayout(QBoxLayout::LeftToRight))
{
    setProperty("role", "welcome");
    setAttribute(Qt::WA_StyledBackground);
    auto* heading = withText(roleLabel("welcome"), [] { return tr("Register a vessel tree to an angiogram"); });
    auto* hint =
        withText(roleLabel("label"), [] { return tr("Drop a case here, or vessels together with an angiogram."); });
    auto* formats = withText(roleLabel("hint"), [] {
        return tr(
            "Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centerlines (VTP, VTK, CSV, SWC).  "
            "Angiograms: DICOM XA, PNG, TIFF.");
    });
    for (QLabel* label : {heading, hint, formats}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
    }
    auto* open = withText(new QPushButton, [] { return withShortcut(tr("Open…"), Command::Open); });
    open->setProperty("role", "primary");
    auto* folder =
        withText(new QPushButton, [] { return withShortcut(tr("Open DICOM folder/CD…"), Command::OpenFolder); });
    withToolTip(folder,
                [] { return tr("Lists the patients, studies and series in a folder, on a CD or in a DICOMDIR."); });
    auto* sample = withText(new QPushButton, [] { return tr("Open the sample case"); });
    buttons_->addStretch(1);
    buttons_->addWidget(open);
    buttons_->addWidget(folder);
    buttons_->addWidget(sample);
    buttons_->addStretch(1);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::folderRequested);
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleRequested);

    auto* list = new QHBoxLayout;
    list->addStretch(1);
    list->addWidget(recent_, 1000);   // large stretch factor, so that the list first grows to its maximum width
    list->addStretch(1);
    auto* layout = new QVBoxLayout(page_);
    layout->setSpacing(12);
    layout->addStretch(2);
    layout->addWidget(heading);
    layout->addWidget(hint);
    layout->addWidget(formats);
    layout->addSpacing(8);
    layout->addLayout(buttons_);
    layout->addSpacing(16);
    layout->addLayout(list);
    layout->addStretch(3);
    auto* area = new QScrollArea;   // scrolls if the screen is too small, e.g. at 200 %
    area->setWidget(page_);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    page_->setAutoFillBackground(false);
    area->viewport()->setAutoFillBackground(false);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area);
}

/// Stacks the buttons vertically if they do not fit side by side.
void WelcomePage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    int needed = 2 * welcomeSideMargin;
    for (int i = 0; i < buttons_->count(); ++i) {
        needed += buttons_->itemAt(i)->sizeHint().width() + buttons_->spacing();
    }
    buttons_->setDirection(needed > width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}   // namespace angiopose::ui
