#pragma once

class QAction;

namespace angiopose::ui {

class AngiogramView;
class ImageTool;

/// Lets a checkable action switch the mode of a tool on and off. The action follows when another mode takes over, or
/// when Esc ends this one.
void bindTool(QAction& action, AngiogramView& view, ImageTool& tool);

}   // namespace angiopose::ui