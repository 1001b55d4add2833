#include "ui/views/tools/bind_tool.h"

#include "ui/views/angiogram_view.h"
#include "ui/views/image_tool.h"

#include <QAction>

namespace angiopose::ui {

void bindTool(QAction& action, AngiogramView& view, ImageTool& tool)
{
    QObject::connect(&action, &QAction::toggled, &tool, [&view, &tool](bool on) {
        if (on) {
            view.setTool(&tool);
        } else if (view.tool() == &tool) {
            view.setTool(nullptr);
        }
    });
    QObject::connect(&view, &AngiogramView::toolChanged, &action,
                     [&action, &view, &tool] { action.setChecked(view.tool() == &tool); });
}

}   // namespace angiopose::ui
