#include "app/preferences/renderer_choice.h"

#include "ui/views/gl_driver.h"

#include <QCoreApplication>

namespace angiopose::app {

QCommandLineOption rendererOption()
{
    return {QStringLiteral("renderer"),
            QCoreApplication::translate("main",
                                        "Who draws the angiogram: vtk (OpenGL), painter (the processor), or auto: "
                                        "vtk where a graphics card does OpenGL."),
            QStringLiteral("auto|vtk|painter"), QStringLiteral("auto")};
}

QString rendererIn(const QCommandLineParser& parser)
{
    return parser.value(QStringLiteral("renderer"));
}

bool applyRenderer(const QCommandLineParser& parser)
{
    const QString name = rendererIn(parser);
    if (name == QLatin1String("vtk")) {
        ui::chooseRenderer(ui::RendererChoice::Vtk);
    } else if (name == QLatin1String("painter")) {
        ui::chooseRenderer(ui::RendererChoice::Painter);
    }
    return name == QLatin1String("vtk") || name == QLatin1String("painter") || name == QLatin1String("auto");
}

}   // namespace angiopose::app
