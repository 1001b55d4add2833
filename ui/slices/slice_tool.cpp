#include "ui/slices/slice_tool.h"

#include "ui/slices/slice_model.h"

#include <QAction>

namespace angiopose::ui {

SliceTool::SliceTool(SliceModel& model) : QObject(&model), model_(model) {}

void SliceTool::requestRepaint()
{
    if (model_.tool() == this) {
        emit model_.toolAppearanceChanged();
    }
}

void bindSliceTool(QAction& action, SliceModel& model, SliceTool& tool)
{
    QObject::connect(&action, &QAction::toggled, &tool, [&model, &tool](bool on) {
        if (on) {
            model.setTool(&tool);
        } else if (model.tool() == &tool) {
            model.setTool(nullptr);
        }
    });
    QObject::connect(&model, &SliceModel::toolChanged, &action,
                     [&action, &model, &tool] { action.setChecked(model.tool() == &tool); });
}

}   // namespace angiopose::ui
