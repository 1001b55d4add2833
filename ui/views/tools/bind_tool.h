#pragma once

class QAction;

namespace angiopose::ui {

class AngiogramView;
class ImageTool;

/// Binds a checkable action to the mode of a tool. The action is unchecked when another mode takes over or Esc ends
/// this one.
void bindTool(QAction& action, AngiogramView& view, ImageTool& tool);

}   // namespace angiopose::ui