#include "ui/slices/slices_page.h"

#include "ui/panels/section.h"
#include "ui/words/spoken.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr int gapPx = 2;   // between the slices: tone, not lines

}   // namespace

SlicesPage::SlicesPage(SliceModel& model, QWidget* parent) : QWidget(parent), model_(model), columns_(new QHBoxLayout)
{
    for (const core::BodyPlane plane : core::bodyPlanes) {
        views_[plane] = new SliceView(model, plane);
        connect(views_[plane], &SliceView::roomRequested, this, &SlicesPage::closeRequested);
    }
    auto* upright = new QVBoxLayout;
    upright->setSpacing(gapPx);
    upright->addWidget(views_[core::BodyPlane::Coronal]);
    upright->addWidget(views_[core::BodyPlane::Sagittal]);
    columns_->setSpacing(gapPx);
    columns_->addWidget(views_[core::BodyPlane::Axial], 3);
    columns_->addLayout(upright, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeBar());
    layout->addLayout(columns_, 1);
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    setFocusProxy(views_[core::BodyPlane::Axial]);
}

void SlicesPage::setSidePanel(QWidget* panel)
{
    auto* column = new QScrollArea;   // on low screens it is taller than the page
    column->setProperty("role", "column");
    column->setWidget(panel);
    column->setWidgetResizable(true);
    column->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    const int scrollBar = column->verticalScrollBar()->sizeHint().width();
    column->setMinimumWidth(panel->minimumWidth() + scrollBar);
    column->setMaximumWidth(panel->maximumWidth() + scrollBar);
    columns_->addWidget(column);
}

QWidget* SlicesPage::makeBar()
{
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(10, 4, 10, 4);
    layout->setSpacing(4);
    layout->addWidget(withText(roleLabel("label"), [] { return tr("Window"); }));
    fillPresets(*layout);
    layout->addStretch(1);
    auto* window = withText(new QPushButton, [] { return tr("Own window"); });
    window->setProperty("role", "link");
    withTip(window, [] { return tr("The slices in a window of their own, and back (F9)"); });
    connect(window, &QPushButton::clicked, this, &SlicesPage::windowRequested);
    layout->addWidget(window);
    auto* back = withText(new QPushButton, [] { return tr("Back to the angiogram"); });
    back->setProperty("role", "link");
    connect(back, &QPushButton::clicked, this, &SlicesPage::closeRequested);
    layout->addWidget(back);
    return bar;
}

void SlicesPage::fillPresets(QHBoxLayout& bar)
{
    const auto add = [&](const Words& name, const Words& tip, auto choose) {
        auto* button = withTip(withText(new QPushButton, name), tip);
        button->setProperty("role", "quiet");
        connect(button, &QPushButton::clicked, this, choose);
        bar.addWidget(button);
    };
    for (const WindowPreset& preset : windowPresets()) {
        add([name = preset.name] { return QCoreApplication::translate("ui::WindowPreset", name); },
            [window = preset.window] {
                return tr("W %1 L %2 HU").arg(window.width, 0, 'f', 0).arg(window.level, 0, 'f', 0);
            },
            [this, window = preset.window] { model_.setWindow(window); });
    }
    add([] { return tr("Automatic"); },
        [] { return tr("From the values of this scan; right drag in a slice changes it by hand."); },
        [this] {
            if (model_.volume()) {
                model_.setWindow(windowOfValues(*model_.volume()));
            }
        });
}

}   // namespace ui
