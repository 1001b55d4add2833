#include "ui/panels/welcome_page.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/section.h"
#include "ui/words/spoken.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent), recent_(new RecentList)
{
    setProperty("role", "welcome");
    setAttribute(Qt::WA_StyledBackground);
    auto* heading = withText(roleLabel("welcome"), [] { return tr("Lay a vessel tree onto its angiogram"); });
    auto* hint =
        withText(roleLabel("label"), [] { return tr("Drop a case here, or vessels together with an angiogram."); });
    auto* formats = withText(roleLabel("hint"), [] {
        return tr(
            "Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centrelines (VTP, VTK, CSV, SWC).  "
            "Angiograms: DICOM XA, PNG, TIFF.");
    });
    for (QLabel* label : {heading, hint, formats}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
    }
    auto* open = withText(new QPushButton, [] { return withKey(tr("Open …"), Command::Open); });
    open->setProperty("role", "primary");
    auto* folder = withText(new QPushButton, [] { return withKey(tr("Open folder or disc …"), Command::OpenFolder); });
    withTip(folder, [] { return tr("Lists the patients, studies and series of a folder, a CD or a DICOMDIR."); });
    auto* sample = withText(new QPushButton, [] { return tr("Open the sample case"); });
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(folder);
    buttons->addWidget(sample);
    buttons->addStretch(1);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::folderRequested);
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleRequested);

    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addStretch(2);
    layout->addWidget(heading);
    layout->addWidget(hint);
    layout->addWidget(formats);
    layout->addSpacing(8);
    layout->addLayout(buttons);
    layout->addSpacing(16);
    layout->addWidget(recent_, 0, Qt::AlignHCenter);
    layout->addStretch(3);
}

}   // namespace angiopose::ui
