#pragma once

class QAction;

namespace angiopose::ui {

class AngiogramView;
class ImageTool;

/// Connects a checkable action with the mode of a tool. The action becomes unchecked when another mode starts or Esc
/// ends this mode.
void bindTool(QAction& action, AngiogramView& view, ImageTool& tool);

}   // namespace angiopose::ui
