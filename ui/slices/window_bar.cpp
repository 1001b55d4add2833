#include "ui/slices/window_bar.h"

#include "ui/controls/section.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

namespace angiopose::ui {
namespace {

constexpr int marginPx = 10;
constexpr int spacingPx = 4;

QPushButton* linkButton(const Words& text)
{
    auto* button = withText(new QPushButton, text);
    button->setProperty("role", "link");
    return button;
}

}   // namespace

WindowBar::WindowBar(SliceModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      presets_(new QWidget),
      row_(new QHBoxLayout(presets_)),
      folded_(withText(new QPushButton, [] { return tr("Window"); })),
      menu_(new QMenu(this)),
      ownWindow_(linkButton([] { return tr("Pop out"); })),
      back_(linkButton([] { return tr("Show angiogram"); }))
{
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(spacingPx);
    row_->addWidget(withText(roleLabel("label"), [] { return tr("Window"); }));
    fillPresets();
    folded_->setProperty("role", "quiet");
    folded_->setMenu(menu_);
    folded_->hide();
    menu_->setToolTipsVisible(true);
    withTip(ownWindow_, [] { return tr("Opens the slices in a separate window and brings them back (F9)"); });
    connect(ownWindow_, &QPushButton::clicked, this, &WindowBar::windowRequested);
    connect(back_, &QPushButton::clicked, this, &WindowBar::closeRequested);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(marginPx, 4, marginPx, 4);
    layout->setSpacing(spacingPx);
    layout->addWidget(presets_);
    layout->addWidget(folded_);
    layout->addStretch(1);
    layout->addWidget(ownWindow_);
    layout->addWidget(back_);
}

void WindowBar::fillPresets()
{
    const auto add = [&](const Words& name, const Words& tip, auto choose) {
        auto* button = withTip(withText(new QPushButton, name), tip);
        button->setProperty("role", "quiet");
        connect(button, &QPushButton::clicked, this, choose);
        row_->addWidget(button);
        QAction* action = withTip(withText(menu_->addAction(QString()), name), tip);
        connect(action, &QAction::triggered, this, choose);
        return std::pair(button, action);
    };
    for (const WindowPreset& preset : windowPresets()) {
        const auto [button, action] =
            add([name = preset.name] { return QCoreApplication::translate("angiopose::ui::WindowPreset", name); },
                [window = preset.window] {
                    return tr("W %1 L %2 HU").arg(numberText(window.width, 0)).arg(numberText(window.level, 0));
                },
                [this, window = preset.window] { model_.setWindow(window); });
        const auto followScan = [this, button = button, action = action] {   // presets are in HU, hence only for CT
            button->setVisible(model_.isHounsfield());
            action->setVisible(model_.isHounsfield());
        };
        followScan();
        connect(&model_, &SliceModel::scanChanged, this, followScan);
    }
    add([] { return tr("Automatic"); },
        [] { return tr("Set from the values of this scan; right-drag in a slice to adjust it manually."); },
        [this] {
            if (model_.volume()) {
                model_.setWindow(windowOfValues(*model_.volume()));
            }
        });
    menu_->addSeparator();
    connect(withText(menu_->addAction(QString()), [] { return tr("Pop out"); }), &QAction::triggered, this,
            &WindowBar::windowRequested);
}

QSize WindowBar::minimumSizeHint() const
{
    return {2 * marginPx + spacingPx + folded_->sizeHint().width() + back_->sizeHint().width(), sizeHint().height()};
}

void WindowBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fold();
}

/// Updates the width after a language change.
bool WindowBar::event(QEvent* event)
{
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        fold();
    }
    return isDone;
}

void WindowBar::fold()
{
    const int wanted = 2 * marginPx + 3 * spacingPx + presets_->sizeHint().width() + ownWindow_->sizeHint().width() +
                       back_->sizeHint().width();
    const bool isNarrow = width() < wanted;
    presets_->setVisible(!isNarrow);
    ownWindow_->setVisible(!isNarrow);
    folded_->setVisible(isNarrow);
}

}   // namespace angiopose::ui
