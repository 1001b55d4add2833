#include "app/preferences/apply_settings.h"
#include "app/start/start_options.h"
#include "app/start/write_report.h"
#include "app/window_host.h"
#include "io/support/crash_dumps.h"
#include "io/support/file_limits.h"

#include <QApplication>
#include <QIcon>

#include <clocale>

using namespace angiopose;

int main(int argc, char** argv)
{
    io::reportFileSizeLimit();
    io::enableCrashDumps("angiopose");
    const app::StartOptions words = app::parseStartOptions(argc, argv);
    if (words.exitCode) {
        return *words.exitCode;
    }
    if (words.report) {
        return app::writeReport(argc, argv, *words.report);
    }
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");   // Qt sets the system's numeric locale, in which libraries may parse 0.8 as 0
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/angiopose.svg")));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.angiopose.AngioPose"));

    app::applyLanguageSetting();
    app::applyShortcutSettings();
    app::applyThemeSetting(application);
    app::WindowHost host;
    host.controller().begin(words.files);
    return QApplication::exec();
}
