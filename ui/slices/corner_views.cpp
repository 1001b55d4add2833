#include "ui/slices/corner_views.h"

#include "ui/actions/key_hint.h"
#include "ui/views/scan_bar.h"
#include "ui/views/tree_view.h"
#include "ui/words/retranslation.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {

CornerViews::CornerViews(TreeView* treeView, SliceModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      bar_(new QWidget),
      allSlices_(makeToolButton(
          QStringLiteral("⊞"), [] { return tr("Enlarge all slices"); }, Command::SlicesLarge)),
      stack_(new QStackedWidget),
      treeView_(treeView),
      slice_(new SliceView(model, core::BodyPlane::Axial)),
      scanBar_(new ScanBar)
{
    stack_->addWidget(treeView_);
    stack_->addWidget(slice_);
    auto* tabs = new QHBoxLayout(bar_);
    tabs->setContentsMargins(8, 4, 4, 2);
    tabs->setSpacing(1);
    tabs_[0] = makeTab([] { return tr("3-D"); }, std::nullopt);
    for (std::size_t i = 0; i < core::bodyPlanes.size(); ++i) {
        tabs_[i + 1] = makeTab([plane = core::bodyPlanes[i]] { return nameOf(plane); }, core::bodyPlanes[i]);
    }
    for (QToolButton* tab : tabs_) {
        tabs->addWidget(tab);
    }
    tabs->addStretch(1);
    QToolButton* alone = makeToolButton(
        QStringLiteral("⤢"), [] { return tr("Show only this view, or restore"); }, Command::CornerOnly);
    QToolButton* window = makeToolButton(
        QStringLiteral("↗"), [] { return tr("Move to a separate window, or back"); }, Command::CornerWindow);
    connect(allSlices_, &QToolButton::clicked, this, &CornerViews::enlargeRequested);
    connect(alone, &QToolButton::clicked, this, &CornerViews::maximizeRequested);
    connect(window, &QToolButton::clicked, this, &CornerViews::popOutRequested);
    connect(slice_, &SliceView::enlargeRequested, this, &CornerViews::enlargeRequested);
    connect(treeView_, &TreeView::enlargeRequested, this, &CornerViews::maximizeRequested);
    for (QToolButton* tool : {allSlices_, alone, window}) {
        tabs->addWidget(tool);
    }
    withToolTip(bar_, [] {
        return tooltipWithShortcut(tr("Double-click: show only this view, or restore"), Command::CornerOnly);
    });
    bar_->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar_);
    layout->addWidget(scanBar_);
    layout->addWidget(stack_, 1);
    connect(&model, &SliceModel::scanChanged, this, &CornerViews::followScan);
    followScan();
}

QToolButton* CornerViews::makeToolButton(const QString& sign, const LocalizedText& name, Command command)
{
    auto* tool = new QToolButton;
    tool->setText(sign);
    tool->setProperty("role", "tabTool");
    withAccessibleName(tool, name);
    withToolTip(tool, [name, command] { return tooltipWithShortcut(name(), command); });
    return tool;
}

bool CornerViews::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == bar_ && event->type() == QEvent::MouseButtonDblClick) {
        emit maximizeRequested();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

QToolButton* CornerViews::makeTab(const LocalizedText& text, std::optional<core::BodyPlane> plane)
{
    auto* tab = new QToolButton;
    withText(tab, text);
    tab->setProperty("role", "tab");
    tab->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);   // keeps the name from being clipped
    tab->setCheckable(true);
    connect(tab, &QToolButton::clicked, this, [this, plane] { showPlane(plane); });
    return tab;
}

std::optional<core::BodyPlane> CornerViews::shownPlane() const
{
    return model_.hasScan() ? requestedPlane_ : std::nullopt;
}

void CornerViews::showPlane(std::optional<core::BodyPlane> plane)
{
    if (plane != requestedPlane_) {
        requestedPlane_ = plane;
        emit planeChanged(plane);
    }
    const auto shown = shownPlane();
    if (shown) {
        slice_->setPlane(*shown);
    }
    stack_->setCurrentWidget(shown ? static_cast<QWidget*>(slice_) : treeView_);
    scanBar_->setVisible(model_.hasScan() && !shown);
    setFocusProxy(stack_->currentWidget());
    for (std::size_t i = 0; i < tabs_.size(); ++i) {
        tabs_[i]->setChecked(i == 0 ? !shown : shown == core::bodyPlanes[i - 1]);
    }
}

void CornerViews::showNext()
{
    const auto& planes = core::bodyPlanes;
    const auto current = requestedPlane_ ? std::find(planes.begin(), planes.end(), *requestedPlane_) : planes.end();
    const auto next = current == planes.end() ? planes.begin() : current + 1;
    showPlane(next == planes.end() ? std::nullopt : std::optional(*next));
}

void CornerViews::followScan()
{
    for (std::size_t i = 1; i < tabs_.size(); ++i) {
        tabs_[i]->setVisible(model_.hasScan());
    }
    allSlices_->setVisible(model_.hasScan());
    showPlane(requestedPlane_);
}

}   // namespace angiopose::ui
