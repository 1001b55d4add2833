#include "ui/views/gl_driver.h"

#include "ui/views/offscreen_context.h"

#include <QOpenGLFunctions>

#include <algorithm>
#include <array>

namespace angiopose::ui {
namespace {

RendererChoice rendererChoice = RendererChoice::Auto;

QString glTextOf(QOpenGLFunctions& functions, GLenum name)
{
    return QString::fromUtf8(reinterpret_cast<const char*>(functions.glGetString(name)));
}

GlDriver queryDriver()
{
    OffscreenContext context;
    if (!context.create() || !context.makeCurrent()) {
        return {};
    }
    QOpenGLFunctions& functions = *context.context().functions();
    GlDriver driver{glTextOf(functions, GL_VENDOR), glTextOf(functions, GL_RENDERER), glTextOf(functions, GL_VERSION)};
    context.doneCurrent();
    return driver;
}

}   // namespace

bool GlDriver::isAccelerated() const
{
    static const std::array<QString, 6> bySoftware{QStringLiteral("llvmpipe"), QStringLiteral("softpipe"),
                                                   QStringLiteral("swrast"),   QStringLiteral("SWR"),
                                                   QStringLiteral("software"), QStringLiteral("SwiftShader")};
    return isAvailable() && std::ranges::none_of(bySoftware, [this](const QString& name) {
               return renderer.contains(name, Qt::CaseInsensitive);
           });
}

const GlDriver& glDriver()
{
    static const GlDriver driver = queryDriver();
    return driver;
}

void chooseRenderer(RendererChoice choice)
{
    rendererChoice = choice;
}

Renderer chosenRenderer()
{
    if (rendererChoice == RendererChoice::Auto) {
        return glDriver().isAccelerated() ? Renderer::Vtk : Renderer::Painter;
    }
    return rendererChoice == RendererChoice::Vtk && glDriver().isAvailable() ? Renderer::Vtk : Renderer::Painter;
}

}   // namespace angiopose::ui
