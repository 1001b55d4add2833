#include "ui/dialogs/good_fit.h"

#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"

#include <QGridLayout>
#include <QImage>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int picturePx = 250;

bool isGood(FitExample example)
{
    return example <= FitExample::Deformed;
}

QString headingOf(FitExample example)
{
    switch (example) {
        case FitExample::Right:
            return GoodFit::tr("Good: everything fits");
        case FitExample::Unopacified:
            return GoodFit::tr("Good: unopacified branches");
        case FitExample::Deformed:
            return GoodFit::tr("Good: vessels have moved");
        case FitExample::Shifted:
            return GoodFit::tr("Bad: shifted");
        case FitExample::Turned:
            return GoodFit::tr("Bad: rotated");
        case FitExample::Tilted:
            break;
    }
    return GoodFit::tr("Bad: wrong gantry angle");
}

QString sentenceOf(FitExample example)
{
    switch (example) {
        case FitExample::Right:
            return GoodFit::tr(
                "The lines follow the vessel centers and are blue throughout, including in the side branches.");
        case FitExample::Unopacified:
            return GoodFit::tr(
                "Amber only where there is no contrast agent in this frame; every opacified vessel is blue.");
        case FitExample::Deformed:
            return GoodFit::tr(
                "Small deviations to both sides due to heartbeat and breathing; no rigid pose fits better.");
        case FitExample::Shifted:
            return GoodFit::tr("All lines are shifted to the same side. Register again, or nudge with the arrow keys.");
        case FitExample::Turned:
            return GoodFit::tr(
                "The lines fit in the center but deviate increasingly toward the edges: the pose is rotated in the "
                "image plane.");
        case FitExample::Tilted:
            break;
    }
    return GoodFit::tr("The trunk fits, but the side branches run in other directions: LAO/RAO or CRA/CAU is wrong.");
}

}   // namespace

GoodFit::GoodFit(QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("goodFit"));
    setWindowTitle(tr("Examples of good and bad fits"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* pictures = new QWidget;
    auto* grid = new QGridLayout(pictures);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(14);
    for (int i = 0; i < fitExampleCount; ++i) {
        grid->addWidget(makeCell(static_cast<FitExample>(i)), i / 3, i % 3);
    }
    auto* note = roleLabel("hint", tr("Simulated vessels. Blue: on a vessel. Amber: off by 2 mm or more."));
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* foot = new QHBoxLayout;
    foot->addWidget(note, 1);
    foot->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(14);
    auto* area = new QScrollArea;   // scrolls on screens too small for all six examples
    area->setWidget(pictures);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    pictures->setAutoFillBackground(false);
    area->viewport()->setAutoFillBackground(false);
    layout->addWidget(area, 1);
    layout->addLayout(foot);
    const QMargins rim = layout->contentsMargins();
    resizeWithinScreen(
        *this, pictures->sizeHint() + QSize(rim.left() + rim.right() + style()->pixelMetric(QStyle::PM_ScrollBarExtent),
                                            rim.top() + rim.bottom() + layout->spacing() + foot->sizeHint().height()));
}

QWidget* GoodFit::makeCell(FitExample example)
{
    auto* cell = new QWidget;
    auto* image = roleLabel("hint", tr("drawing…"));
    image->setFixedSize(picturePx, picturePx);
    image->setAlignment(Qt::AlignCenter);
    image->setAccessibleName(headingOf(example));
    exampleLabels_[static_cast<std::size_t>(example)] = image;
    const QString mark = isGood(example) ? QStringLiteral("✓ ") : QStringLiteral("! ");
    auto* heading = roleLabel(isGood(example) ? "heading" : "attention", mark + headingOf(example));
    auto* sentence = roleLabel("label", sentenceOf(example));
    sentence->setWordWrap(true);
    sentence->setFixedWidth(picturePx);
    sentence->ensurePolished();
    sentence->setMinimumHeight(sentence->heightForWidth(picturePx));   // nested layouts do not support height-for-width
    auto* layout = new QVBoxLayout(cell);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(image);
    layout->addWidget(heading);
    layout->addWidget(sentence);
    layout->addStretch(1);
    return cell;
}

void GoodFit::showExample(FitExample example, const QImage& image)
{
    QLabel* label = exampleLabels_[static_cast<std::size_t>(example)];
    const double ratio = devicePixelRatioF();
    const int side = static_cast<int>(picturePx * ratio);
    QPixmap shown = QPixmap::fromImage(image.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    shown.setDevicePixelRatio(ratio);
    label->setPixmap(shown);
}

void GoodFit::showProblem(const QString& reason)
{
    for (QLabel* label : exampleLabels_) {
        if (label->pixmap().isNull()) {
            label->setWordWrap(true);
            label->setText(reason);
        }
    }
}

}   // namespace angiopose::ui
