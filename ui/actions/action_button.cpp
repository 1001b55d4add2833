#include "ui/actions/action_button.h"

#include "ui/actions/key_hint.h"

#include <QAction>
#include <QPushButton>

namespace angiopose::ui {

QPushButton* modeButton(const Words& text, Command command)
{
    auto* button = withText(new QPushButton, text);
    withTip(button, [text, command] { return withKey(text(), command); });
    button->setCheckable(true);
    return button;
}

void follow(QPushButton& button, QAction& action)
{
    QObject::connect(&button, &QPushButton::clicked, &action, [&action](bool on) {
        if (action.isCheckable()) {
            action.setChecked(on);
        } else {
            action.trigger();
        }
    });
    const auto look = [&button, &action] {
        button.setEnabled(action.isEnabled());
        button.setChecked(action.isChecked());
    };
    QObject::connect(&action, &QAction::changed, &button, look);
    look();
}

}   // namespace angiopose::ui
