#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace angiopose::ui {

/// OpenGL 3.2 core context without a window. Use it on the GUI thread only.
class OffscreenContext {
public:
    bool create();   ///< returns false if the computer or display does not support such a context
    bool makeCurrent() { return context_.makeCurrent(&surface_); }
    bool isCurrent() const { return QOpenGLContext::currentContext() == &context_; }
    void doneCurrent() { context_.doneCurrent(); }
    QOpenGLContext& context() { return context_; }

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
};

}   // namespace angiopose::ui
