#include "ui/panels/view_strip.h"

#include "ui/actions/key_hint.h"
#include "ui/words/spoken.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int viewPictureSize = 52;

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
    withName(list_, [] { return tr("Views of the case"); });
    list_->setFlow(QListView::LeftToRight);
    list_->setMovement(QListView::Static);
    list_->setWrapping(false);
    list_->setIconSize({viewPictureSize, viewPictureSize});
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFixedHeight(viewPictureSize + 10);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* add = new QToolButton;
    add->setText(QStringLiteral("+"));
    withName(add, [] { return tr("Add a view"); });
    withTip(add, [] { return tr("Another angiogram of the same vessels (Ctrl+Shift+V)"); });
    withText(sideBySide_, [] { return tr("Side by side"); });
    withTip(sideBySide_,
            [] { return tipWithKey(tr("All views beside each other, or the shown one alone"), Command::SideBySide); });
    sideBySide_->setCheckable(true);
    withText(crosshair_, [] { return tr("Cross-hair"); });
    withTip(crosshair_, [] {
        return tipWithKey(
            tr("What is under the pointer in one view is a line in the others, and a point on the vessels"),
            Command::LinkedCrosshair);
    });
    crosshair_->setCheckable(true);
    crosshair_->hide();
    for (QToolButton* button : {sideBySide_, crosshair_}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 2, 8, 2);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    auto* switches = new QVBoxLayout;   // one over the other: the width is for the pictures
    switches->setSpacing(2);
    switches->addWidget(sideBySide_);
    switches->addWidget(crosshair_);
    layout->addLayout(switches);
    layout->addWidget(add);
    connect(add, &QToolButton::clicked, this, &ViewStrip::addRequested);
    connect(crosshair_, &QToolButton::clicked, this, &ViewStrip::crosshairRequested);
    connect(sideBySide_, &QToolButton::clicked, this, &ViewStrip::sideBySideRequested);
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
    list_->installEventFilter(this);
    hide();
}

bool ViewStrip::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != list_ || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Delete) {
        return QWidget::eventFilter(watched, event);
    }
    event->accept();   // in the strip this key is about views, not branches
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
    for (int i = 0; i < count; ++i) {
        const ViewLine& view = views[static_cast<std::size_t>(i)];
        list_->item(i)->setText(view.words);
        list_->item(i)->setToolTip(view.toolTip);
    }
    list_->setCurrentRow(shown);
    setVisible(count > 1);
}

void ViewStrip::showPicture(int index, const core::ColorImage& picture)
{
    QListWidgetItem* item = list_->item(index);
    if (!item) {
        return;
    }
    const uchar* bytes = picture.rgb.data();
    const QImage image(bytes, picture.width, picture.height, qsizetype{3} * picture.width, QImage::Format_RGB888);
    QPixmap pixmap = QPixmap::fromImage(image.copy());   // the picture goes away
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);   // no tint over the picture
    item->setIcon(icon);
}

}   // namespace angiopose::ui