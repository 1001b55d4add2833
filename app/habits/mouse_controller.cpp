#include "app/habits/mouse_controller.h"

#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/views/angiogram_view.h"

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

struct MouseChoice {
    ui::Command command;
    const char* name;
    ui::MousePreset preset;
};

constexpr std::array mouseChoices{MouseChoice{ui::Command::MouseRadiology, "radiology", ui::radiologyMouse},
                                  MouseChoice{ui::Command::MouseSlicer, "slicer", ui::slicerMouse},
                                  MouseChoice{ui::Command::MouseScroll, "scroll", ui::scrollMouse}};

const MouseChoice& chosenMouseChoice()
{
    const QString name = settings::mouse.read();
    const auto* found = std::ranges::find_if(
        mouseChoices, [&name](const MouseChoice& choice) { return name == QLatin1String(choice.name); });
    return found == mouseChoices.end() ? mouseChoices.front() : *found;
}

}   // namespace

ui::MousePreset chosenMouse()
{
    return chosenMouseChoice().preset;
}

MouseController::MouseController(ui::WindowActions& actions, ui::AngiogramView& view, QObject* parent) : QObject(parent)
{
    for (const MouseChoice& choice : mouseChoices) {
        connect(actions[choice.command], &QAction::triggered, this, [&view, &choice] {
            settings::mouse.write(QString::fromLatin1(choice.name));
            view.setMousePreset(choice.preset);
        });
    }
    actions[chosenMouseChoice().command]->setChecked(true);
    view.setMousePreset(chosenMouse());
}

}   // namespace angiopose::app