#include "ui/panels/view_strip.h"

#include "ui/actions/key_hint.h"
#include "ui/words/spoken.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int viewPictureSize = 52;
constexpr int minPictureSize = 28;
constexpr int viewItemPadding = 32;   // padding around and between thumbnail and text
constexpr int numberPadding = 22;   // padding around and between thumbnail and number
constexpr int listRim = 4;   // padding of the list around its items
constexpr int fewestWordsPx = 40;   // minimum width of readable text

QPixmap emptyPicture(double ratio)
{
    const int side = static_cast<int>(viewPictureSize * ratio);
    QPixmap empty(side, side);
    empty.fill(Qt::black);
    empty.setDevicePixelRatio(ratio);
    return empty;
}

}   // namespace

ViewStrip::ViewStrip(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), sideBySide_(new QToolButton), crosshair_(new QToolButton)
{
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    auto* add = new QToolButton;
    add->setText(QStringLiteral("+"));
    withName(add, [] { return tr("Add a view"); });
    withTip(add, [] { return tr("Adds another angiogram of the same vessels (Ctrl+Shift+V)"); });
    connect(add, &QToolButton::clicked, this, &ViewStrip::addRequested);
    setUpList();

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 2, 8, 2);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    layout->addLayout(placedSwitches());
    layout->addWidget(add);
    hide();
}

void ViewStrip::setUpList()
{
    withName(list_, [] { return tr("Views"); });
    list_->setFlow(QListView::LeftToRight);
    list_->setMovement(QListView::Static);
    list_->setWrapping(false);
    list_->setIconSize({viewPictureSize, viewPictureSize});
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFixedHeight(viewPictureSize + 10);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->installEventFilter(this);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!showing_ && row >= 0) {
            emit viewPicked(row);
        }
    });
    connect(list_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (const QListWidgetItem* item = list_->itemAt(at)) {
            emit menuRequested(list_->row(item), list_->viewport()->mapToGlobal(at));
        }
    });
}

/// Stacks the toggle buttons vertically to leave more width to the thumbnails.
QLayout* ViewStrip::placedSwitches()
{
    sideBySide_->setIcon(QIcon(QStringLiteral(":/icons/side_by_side.svg")));
    crosshair_->setIcon(QIcon(QStringLiteral(":/icons/crosshair.svg")));
    withText(sideBySide_, [] { return tr("Side by side"); });
    withTip(sideBySide_,
            [] { return tipWithKey(tr("Shows all views side by side or only the current one"), Command::SideBySide); });
    withText(crosshair_, [] { return tr("Crosshair"); });
    withTip(crosshair_, [] {
        return tipWithKey(tr("Shows the point under the pointer as an epipolar line in the other views and as a point "
                             "on the vessels"),
                          Command::LinkedCrosshair);
    });
    crosshair_->hide();
    connect(crosshair_, &QToolButton::clicked, this, &ViewStrip::crosshairRequested);
    connect(sideBySide_, &QToolButton::clicked, this, &ViewStrip::sideBySideRequested);
    auto* switches = new QVBoxLayout;
    switches->setSpacing(2);
    for (QToolButton* button : {sideBySide_, crosshair_}) {
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        switches->addWidget(button);
    }
    return switches;
}

bool ViewStrip::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != list_ || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Delete) {
        return QWidget::eventFilter(watched, event);
    }
    event->accept();   // Delete acts on views, not branches
    if (event->type() == QEvent::KeyPress) {
        emit removeRequested(list_->currentRow());
    }
    return true;
}

int ViewStrip::pictureWidthPx() const
{
    return static_cast<int>(viewPictureSize * devicePixelRatioF());
}

void ViewStrip::showSideBySide(bool on)
{
    sideBySide_->setChecked(on);
    crosshair_->setVisible(on);
    fit();
}

void ViewStrip::showCrosshair(bool on)
{
    crosshair_->setChecked(on);
}

int ViewStrip::count() const
{
    return list_->count();
}

void ViewStrip::showViews(const std::vector<ViewLine>& views, int shown)
{
    const QScopedValueRollback quiet(showing_, true);
    const int count = static_cast<int>(views.size());
    while (list_->count() > count) {
        delete list_->takeItem(list_->count() - 1);
    }
    while (list_->count() < count) {
        new QListWidgetItem(QIcon(emptyPicture(devicePixelRatioF())), {}, list_);
    }
    views_ = views;
    list_->setCurrentRow(shown);
    setVisible(count > 1);
    fit();
}

void ViewStrip::resizeEvent(QResizeEvent*)
{
    fit();
}

int ViewStrip::wordsWidthPx(int index) const
{
    const QStringList lines = views_[static_cast<std::size_t>(index)].words.split(QLatin1Char('\n'));
    int widest = 0;
    for (const QString& line : lines) {
        widest = std::max(widest, list_->fontMetrics().horizontalAdvance(line));
    }
    return viewPictureSize + viewItemPadding + widest;
}

/// Shows text on the toggle buttons if text still fits beside every thumbnail, otherwise icons.
void ViewStrip::fit()
{
    const int count = std::min(list_->count(), static_cast<int>(views_.size()));
    if (count == 0) {
        return;
    }
    const auto roomFor = [&] {
        layout()->activate();
        return (list_->width() - listRim) / count;
    };
    fitSwitches(true);
    int room = roomFor();
    if (room < viewPictureSize + viewItemPadding + fewestWordsPx) {
        fitSwitches(false);
        room = roomFor();
    }
    const bool hasWords = room >= viewPictureSize + viewItemPadding + fewestWordsPx;
    const int besideNumber = room - numberPadding - list_->fontMetrics().horizontalAdvance(QString::number(count));
    const int side = hasWords ? viewPictureSize : std::clamp(besideNumber, minPictureSize, viewPictureSize);
    list_->setIconSize({side, side});
    for (int i = 0; i < count; ++i) {
        fitItem(i, hasWords ? std::min(wordsWidthPx(i), room) : 0);
    }
}

void ViewStrip::fitSwitches(bool hasWords)
{
    for (QToolButton* button : {sideBySide_, crosshair_}) {
        button->setToolButtonStyle(hasWords ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
    }
}

/// Sets the text and width of an item; with `widthPx` 0, a number replaces the text.
void ViewStrip::fitItem(int index, int widthPx)
{
    const ViewLine& view = views_[static_cast<std::size_t>(index)];
    const bool isWhole = widthPx > 0 && wordsWidthPx(index) <= widthPx;
    const QString number = QString::number(index + 1);
    const int numberPx = list_->iconSize().width() + numberPadding + list_->fontMetrics().horizontalAdvance(number);
    QListWidgetItem* item = list_->item(index);
    item->setText(widthPx > 0 ? view.words : number);
    item->setToolTip(isWhole ? view.toolTip : view.words + QLatin1Char('\n') + view.toolTip);
    item->setSizeHint({widthPx > 0 ? widthPx : numberPx, viewPictureSize + 6});
}

void ViewStrip::showPicture(int index, const core::ColorImage& picture)
{
    QListWidgetItem* item = list_->item(index);
    if (!item) {
        return;
    }
    const uchar* bytes = picture.rgb.data();
    const QImage image(bytes, picture.width, picture.height, qsizetype{3} * picture.width, QImage::Format_RGB888);
    QPixmap pixmap = QPixmap::fromImage(image.copy());   // deep copy of the temporary buffer
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);   // keeps the thumbnail untinted in the selected item
    item->setIcon(icon);
}

}   // namespace angiopose::ui
