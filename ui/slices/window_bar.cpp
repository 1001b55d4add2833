#include "ui/slices/window_bar.h"

#include "ui/controls/section.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

namespace angiopose::ui {
namespace {

constexpr int marginPx = 10;
constexpr int spacingPx = 4;

QPushButton* makeLinkButton(const LocalizedText& text)
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
      menuButton_(withText(new QPushButton, [] { return tr("Window"); })),
      menu_(new QMenu(this)),
      popOut_(makeLinkButton([] { return tr("Pop out"); })),
      back_(makeLinkButton([] { return tr("Show angiogram"); }))
{
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(spacingPx);
    row_->addWidget(withText(roleLabel("label"), [] { return tr("Window"); }));
    fillPresets();
    menuButton_->setProperty("role", "quiet");
    menuButton_->setMenu(menu_);
    menuButton_->hide();
    menu_->setToolTipsVisible(true);
    withToolTip(popOut_, [] { return tr("Opens the slices in a separate window and brings them back (F9)"); });
    connect(popOut_, &QPushButton::clicked, this, &WindowBar::popOutRequested);
    connect(back_, &QPushButton::clicked, this, &WindowBar::closeRequested);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(marginPx, 4, marginPx, 4);
    layout->setSpacing(spacingPx);
    layout->addWidget(presets_);
    layout->addWidget(menuButton_);
    layout->addStretch(1);
    layout->addWidget(popOut_);
    layout->addWidget(back_);
}

void WindowBar::fillPresets()
{
    const auto add = [&](const LocalizedText& name, const LocalizedText& tip, auto choose) {
        auto* button = withToolTip(withText(new QPushButton, name), tip);
        button->setProperty("role", "quiet");
        connect(button, &QPushButton::clicked, this, choose);
        row_->addWidget(button);
        QAction* action = withToolTip(withText(menu_->addAction(QString()), name), tip);
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
        const auto followScan = [this, button = button, action = action] {   // presets are in HU and hence only for CT
            button->setVisible(model_.isHounsfield());
            action->setVisible(model_.isHounsfield());
        };
        followScan();
        connect(&model_, &SliceModel::scanChanged, this, followScan);
    }
    add([] { return tr("Automatic"); },
        [] {
            return tr(
                "Sets the window automatically from the values of this scan; right-drag in a slice to adjust it "
                "manually.");
        },
        [this] {
            if (model_.volume()) {
                model_.setWindow(autoWindow(*model_.volume()));
            }
        });
    menu_->addSeparator();
    connect(withText(menu_->addAction(QString()), [] { return tr("Pop out"); }), &QAction::triggered, this,
            &WindowBar::popOutRequested);
}

QSize WindowBar::minimumSizeHint() const
{
    return {2 * marginPx + spacingPx + menuButton_->sizeHint().width() + back_->sizeHint().width(),
            sizeHint().height()};
}

void WindowBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    collapse();
}

/// Updates the width after a language change.
bool WindowBar::event(QEvent* event)
{
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        collapse();
    }
    return isDone;
}

void WindowBar::collapse()
{
    const int requiredWidth = 2 * marginPx + 3 * spacingPx + presets_->sizeHint().width() +
                              popOut_->sizeHint().width() + back_->sizeHint().width();
    const bool isNarrow = width() < requiredWidth;
    presets_->setVisible(!isNarrow);
    popOut_->setVisible(!isNarrow);
    menuButton_->setVisible(isNarrow);
}

}   // namespace angiopose::ui
