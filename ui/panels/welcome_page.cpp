#include "ui/panels/welcome_page.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/section.h"
#include "ui/theme/active_theme.h"
#include "ui/words/spoken.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <span>

namespace angiopose::ui {
namespace {

constexpr std::size_t shownRecent = 5;
constexpr int welcomePictureSize = 44;
constexpr int greatestWidth = 420;

/// The middle of the picture as a square, sharp at any scale; the program's sign on a tile where there is none.
QIcon tileOf(const QImage& picture, double ratio)
{
    const int side = static_cast<int>(std::lround(welcomePictureSize * ratio));
    QPixmap tile(side, side);
    tile.fill(toQColor(activePalette().field));
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (picture.isNull()) {
        QIcon(QStringLiteral(":/icons/angiopose.svg"))
            .paint(&painter, tile.rect().adjusted(side / 5, side / 5, -side / 5, -side / 5));
    } else {
        const int cut = std::min(picture.width(), picture.height());
        painter.drawImage(tile.rect(), picture,
                          QRect((picture.width() - cut) / 2, (picture.height() - cut) / 2, cut, cut));
    }
    painter.end();
    tile.setDevicePixelRatio(ratio);
    return tile;
}

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

/// A button with the picture of the case beside its name; a case without picture has the program's sign.
QPushButton* WelcomePage::makeRecent(const RecentCase& recent)
{
    const QFileInfo file(recent.path);
    const bool missing = !file.exists();
    auto* button = new QPushButton(missing ? tr("%1 (missing)").arg(file.fileName()) : file.fileName());
    button->setProperty("role", "recent");
    button->setIconSize({welcomePictureSize, welcomePictureSize});
    button->setIcon(tileOf(missing ? QImage() : recent.picture, devicePixelRatioF()));
    button->setToolTip(recent.path);
    button->setEnabled(!missing);
    connect(button, &QPushButton::clicked, this, [this, path = recent.path] { emit recentRequested(path); });
    return button;
}

void WelcomePage::showRecent(const std::vector<RecentCase>& cases)
{
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (cases.empty()) {
        return;
    }
    int widest = 0;
    QList<QPushButton*> buttons;
    for (const RecentCase& recent : std::span(cases).first(std::min(cases.size(), shownRecent))) {
        buttons << makeRecent(recent);
        recent_->addWidget(buttons.back(), 0, Qt::AlignHCenter);
        widest = std::max(widest, buttons.back()->sizeHint().width());
    }
    for (QPushButton* button : buttons) {   // names begin below each other
        button->setMinimumWidth(std::min(widest, greatestWidth));
        button->setMaximumWidth(greatestWidth);
    }
    auto* clear = new QPushButton(tr("Clear the list"));
    clear->setProperty("role", "link");
    clear->setToolTip(tr("Forgets these cases and removes their pictures; the case files stay."));
    connect(clear, &QPushButton::clicked, this, &WelcomePage::clearRequested);
    recent_->addWidget(clear, 0, Qt::AlignHCenter);
}

}   // namespace angiopose::ui