#include "app/habits/mouse_controller.h"

#include "app/settings.h"
#include "ui/main_window.h"
#include "ui/views/angiogram_view.h"

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

struct Choice {
    ui::Command command;
    const char* name;
    ui::MousePreset preset;
};

constexpr std::array choices{Choice{ui::Command::MouseRadiology, "radiology", ui::radiologyMouse},
                             Choice{ui::Command::MouseSlicer, "slicer", ui::slicerMouse},
                             Choice{ui::Command::MouseScroll, "scroll", ui::scrollMouse}};

const Choice& chosen()
{
    const QString name = settings::mouse.read();
    const auto* found =
        std::ranges::find_if(choices, [&name](const Choice& choice) { return name == QLatin1String(choice.name); });
    return found == choices.end() ? choices.front() : *found;
}

}   // namespace

ui::MousePreset chosenMouse()
{
    return chosen().preset;
}

MouseController::MouseController(ui::MainWindow& window, QObject* parent) : QObject(parent)
{
    for (const Choice& choice : choices) {
        connect(window.actions()[choice.command], &QAction::triggered, this, [&window, &choice] {
            settings::mouse.write(QString::fromLatin1(choice.name));
            window.angiogramView().setMousePreset(choice.preset);
        });
    }
    window.actions()[chosen().command]->setChecked(true);
    window.angiogramView().setMousePreset(chosen().preset);
}

}   // namespace angiopose::app