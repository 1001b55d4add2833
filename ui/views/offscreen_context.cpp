#include "ui/views/offscreen_context.h"

#include <QSurfaceFormat>

namespace angiopose::ui {

bool OffscreenContext::create()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context_.setFormat(format);
    if (!context_.create()) {
        return false;
    }
    surface_.setFormat(context_.format());
    surface_.create();
    const bool isUsable = makeCurrent() && context_.format().version() >= qMakePair(3, 2);
    doneCurrent();
    return isUsable;
}

}   // namespace angiopose::ui
