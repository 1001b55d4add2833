#include "ui/panels/welcome_page.h"

#include "ui/actions/key_hint.h"
#include "ui/panels/section.h"
#include "ui/words/spoken.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr qsizetype shownRecent = 5;

}   // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent), recent_(new QVBoxLayout)
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
    auto* sample = withText(new QPushButton, [] { return tr("Open the sample case"); });
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(sample);
    buttons->addStretch(1);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleRequested);

    recent_->setSpacing(2);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addStretch(2);
    layout->addWidget(heading);
    layout->addWidget(hint);
    layout->addWidget(formats);
    layout->addSpacing(8);
    layout->addLayout(buttons);
    layout->addSpacing(16);
    layout->addLayout(recent_);
    layout->addStretch(3);
}

void WelcomePage::showRecent(const QStringList& paths)
{
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString& path : paths.first(std::min(paths.size(), shownRecent))) {
        const QFileInfo file(path);
        const bool missing = !file.exists();
        auto* button = new QPushButton(missing ? tr("%1 (missing)").arg(file.fileName()) : file.fileName());
        button->setProperty("role", "link");
        button->setToolTip(path);
        button->setEnabled(!missing);
        connect(button, &QPushButton::clicked, this, [this, path] { emit recentRequested(path); });
        recent_->addWidget(button, 0, Qt::AlignHCenter);
    }
}

}   // namespace ui
