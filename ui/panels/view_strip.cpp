#include "ui/panels/view_strip.h"

#include "ui/actions/key_hint.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int viewThumbnailSize = 52;
constexpr int minThumbnailSize = 28;
constexpr int viewItemPadding = 32;   // padding around and between thumbnail and text
constexpr int numberPadding = 22;   // padding around and between thumbnail and number
constexpr int listRim = 4;   // padding of the list around its items
constexpr int minTextWidthPx = 40;   // minimum width of readable text

QPixmap emptyThumbnail(double ratio)
{
    const int side = static_cast<int>(viewThumbnailSize * ratio);
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
    withAccessibleName(add, [] { return tr("Add a view"); });
    withToolTip(add, [] { return tr("Adds another angiogram of the same vessels (Ctrl+Shift+V)"); });
    connect(add, &QToolButton::clicked, this, &ViewStrip::addRequested);
    setUpList();

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 2, 8, 2);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    layout->addLayout(makeSwitches());
    layout->addWidget(add);
    hide();
}

void ViewStrip::setUpList()
{
    withAccessibleName(list_, [] { return tr("Views"); });
    list_->setFlow(QListView::LeftToRight);
    list_->setMovement(QListView::Static);
    list_->setWrapping(false);
    list_->setIconSize({viewThumbnailSize, viewThumbnailSize});
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFixedHeight(viewThumbnailSize + 10);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->installEventFilter(this);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!isUpdating_ && row >= 0) {
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
QLayout* ViewStrip::makeSwitches()
{
    sideBySide_->setIcon(QIcon(QStringLiteral(":/icons/side_by_side.svg")));
    crosshair_->setIcon(QIcon(QStringLiteral(":/icons/crosshair.svg")));
    withText(sideBySide_, [] { return tr("Side by side"); });
    withToolTip(sideBySide_, [] {
        return tooltipWithShortcut(tr("Shows all views side by side or only the current one"), Command::SideBySide);
    });
    withText(crosshair_, [] { return tr("Crosshair"); });
    withToolTip(crosshair_, [] {
        return tooltipWithShortcut(tr("Shows the point under the mouse pointer as an epipolar line in the other views "
                                      "and as a point on the vessels"),
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
    event->accept();   // Delete applies to views here, not to branches
    if (event->type() == QEvent::KeyPress) {
        emit removeRequested(list_->currentRow());
    }
    return true;
}

int ViewStrip::thumbnailWidthPx() const
{
    return static_cast<int>(viewThumbnailSize * devicePixelRatioF());
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

void ViewStrip::showViews(const std::vector<ViewRow>& views, int shown)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    const int count = static_cast<int>(views.size());
    while (list_->count() > count) {
        delete list_->takeItem(list_->count() - 1);
    }
    while (list_->count() < count) {
        new QListWidgetItem(QIcon(emptyThumbnail(devicePixelRatioF())), {}, list_);
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

int ViewStrip::textWidthPx(int index) const
{
    const QStringList lines = views_[static_cast<std::size_t>(index)].label.split(QLatin1Char('\n'));
    int widest = 0;
    for (const QString& line : lines) {
        widest = std::max(widest, list_->fontMetrics().horizontalAdvance(line));
    }
    return viewThumbnailSize + viewItemPadding + widest;
}

/// Shows text on the toggle buttons if the captions still fit beside every thumbnail, otherwise icons.
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
    int availablePx = roomFor();
    if (availablePx < viewThumbnailSize + viewItemPadding + minTextWidthPx) {
        fitSwitches(false);
        availablePx = roomFor();
    }
    const bool hasText = availablePx >= viewThumbnailSize + viewItemPadding + minTextWidthPx;
    const int besideNumber =
        availablePx - numberPadding - list_->fontMetrics().horizontalAdvance(QString::number(count));
    const int side = hasText ? viewThumbnailSize : std::clamp(besideNumber, minThumbnailSize, viewThumbnailSize);
    list_->setIconSize({side, side});
    for (int i = 0; i < count; ++i) {
        fitItem(i, hasText ? std::min(textWidthPx(i), availablePx) : 0);
    }
}

void ViewStrip::fitSwitches(bool hasText)
{
    for (QToolButton* button : {sideBySide_, crosshair_}) {
        button->setToolButtonStyle(hasText ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
    }
}

/// Sets the text and the width of an item; if `widthPx` is 0, a number replaces the text.
void ViewStrip::fitItem(int index, int widthPx)
{
    const ViewRow& view = views_[static_cast<std::size_t>(index)];
    const bool isWhole = widthPx > 0 && textWidthPx(index) <= widthPx;
    const QString number = QString::number(index + 1);
    const int numberPx = list_->iconSize().width() + numberPadding + list_->fontMetrics().horizontalAdvance(number);
    QListWidgetItem* item = list_->item(index);
    item->setText(widthPx > 0 ? view.label : number);
    item->setToolTip(isWhole ? view.toolTip : view.label + QLatin1Char('\n') + view.toolTip);
    item->setSizeHint({widthPx > 0 ? widthPx : numberPx, viewThumbnailSize + 6});
}

void ViewStrip::showThumbnail(int index, const core::ColorImage& picture)
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
