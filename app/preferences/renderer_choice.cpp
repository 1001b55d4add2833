#include "app/preferences/renderer_choice.h"

#include "ui/views/gl_driver.h"

#include <QApplication>
#include <QTextStream>

#include <cstdio>
#include <cstdlib>

namespace angiopose::app {

QCommandLineOption rendererOption()
{
    return {QStringLiteral("renderer"),
            QApplication::translate("main",
                                    "Who draws the angiogram: vtk (OpenGL), painter (the processor), or auto: "
                                    "vtk where a graphics card does OpenGL."),
            QStringLiteral("auto|vtk|painter"), QStringLiteral("auto")};
}

void applyRenderer(const QCommandLineParser& parser)
{
    const QString name = parser.value(QStringLiteral("renderer"));
    if (name == QLatin1String("vtk")) {
        ui::chooseRenderer(ui::RendererChoice::Vtk);
    } else if (name == QLatin1String("painter")) {
        ui::chooseRenderer(ui::RendererChoice::Painter);
    } else if (name != QLatin1String("auto")) {
        QTextStream(stderr)
            << QApplication::translate("main", "No renderer is called “%1”: auto, vtk or painter.").arg(name) << '\n';
        std::exit(2);
    }
}

}   // namespace angiopose::app
