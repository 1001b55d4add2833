#include "ui/views/image_tool.h"

#include "ui/views/angiogram_view.h"

namespace angiopose::ui {

ImageTool::ImageTool(AngiogramView& view) : QObject(&view), view_(view) {}

const Color& ImageTool::tone() const
{
    return palette(ThemeMode::Dark).accent;   // images have a dark background in every theme
}

}   // namespace angiopose::ui
