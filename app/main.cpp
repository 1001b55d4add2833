#include "app/preferences/key_choice.h"
#include "app/preferences/language_choice.h"
#include "app/preferences/renderer_choice.h"
#include "app/preferences/theme_choice.h"
#include "app/window_host.h"
#include "io/support/file_limits.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>

using namespace angiopose;

int main(int argc, char** argv)
{
    io::reportFileSizeLimit();
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationVersion(QStringLiteral(ANGIOPOSE_VERSION));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/angiopose.svg")));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.angiopose.AngioPose"));

    app::applyChosenLanguage();
    app::applyChosenKeys();

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate(
        "main", "Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
                                 QApplication::translate("main", "A case, or a centreline and an angiogram."),
                                 QStringLiteral("[case|files…]"));
    parser.addOption(app::rendererOption());
    parser.process(application);
    app::applyRenderer(parser);

    app::applyChosenTheme(application);
    app::WindowHost host;
    host.controller().begin(parser.positionalArguments());
    return QApplication::exec();
}
