#include "ui/theme/active_theme.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QThreadPool>

using namespace angiopose;

namespace {

/// Resets the settings and the application-wide color scheme before each test.
class FreshPreferences : public ::testing::EmptyTestEventListener {
    void OnTestStart(const ::testing::TestInfo&) override
    {
        QSettings().clear();
        ui::setColorScheme(ui::ColorScheme::BlueAmber);
    }
};

}   // namespace

// Runs window tests in an application that keeps its settings and data in a separate folder.
int main(int argc, char** argv)
{
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    qputenv("XDG_CACHE_HOME", home.path().toUtf8());
    qputenv("XDG_STATE_HOME", home.path().toUtf8());
    ::testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPoseTest"));
    QApplication::setQuitOnLastWindowClosed(false);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    ui::applyTheme(application, ui::ThemeMode::Dark);
    ::testing::UnitTest::GetInstance()->listeners().Append(new FreshPreferences);
    const int failures = RUN_ALL_TESTS();
    QThreadPool::globalInstance()->waitForDone();
    return failures;
}
