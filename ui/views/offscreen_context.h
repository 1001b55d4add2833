#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace angiopose::ui {

/// An OpenGL 3.2 core context that draws into no window. Belongs to the thread of the user interface.
class OffscreenContext {
public:
    bool create();   ///< false when this computer or display offers no such context
    bool makeCurrent() { return context_.makeCurrent(&surface_); }
    bool isCurrent() const { return QOpenGLContext::currentContext() == &context_; }
    void doneCurrent() { context_.doneCurrent(); }
    QOpenGLContext& context() { return context_; }

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
};

}   // namespace angiopose::ui