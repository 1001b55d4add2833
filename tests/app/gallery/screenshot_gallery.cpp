#include "app/preferences/settings.h"
#include "tests/app/gallery/clipped_texts.h"
#include "tests/app/gallery/gallery.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>
#include <QThreadPool>

#include <cstdio>

using namespace angiopose;

namespace {

/// Checks the detector of clipped texts itself: it must find a button that is half as wide as its text.
bool seesClippedWords()
{
    QWidget page;
    page.resize(200, 60);
    QPushButton button(QStringLiteral("Wirklich lange Aufschrift"), &page);
    button.setGeometry(0, 0, button.sizeHint().width() / 2, 30);
    page.show();
    return test::clippedTexts(page).size() == 1;
}

}   // namespace

// Takes screenshots of every panel and of the whole window, in all languages and themes, at the scale of
// QT_SCALE_FACTOR. Also a test: fails when a text is clipped or a panel is empty.
int main(int argc, char** argv)
{
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    qputenv("XDG_CACHE_HOME", home.path().toUtf8());
    const QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPoseGallery"));
    QApplication::setQuitOnLastWindowClosed(false);
    app::settings::noticeAccepted.write(true);
    app::settings::reduceMotion.write(true);

    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Pictures of the window, its panels and dialogs."));
    parser.addHelpOption();
    parser.addOption(
        {QStringLiteral("language"), QStringLiteral("en, de or zh_CN; all when not given"), QStringLiteral("code")});
    parser.addOption(
        {QStringLiteral("theme"), QStringLiteral("dark or light; both when not given"), QStringLiteral("name")});
    parser.addOption({QStringLiteral("scan"), QStringLiteral("pictures of this scan, and nothing else"),
                      QStringLiteral("file or folder")});
    parser.addPositionalArgument(QStringLiteral("folder"), QStringLiteral("for the pictures; none: only looks"));
    parser.process(application);
    const QString folder = parser.positionalArguments().value(0);
    if (!folder.isEmpty()) {
        QDir().mkpath(folder);
    }
    const auto chosen = [&parser](const char* option, const QStringList& all) {
        const QString value = parser.value(QString::fromLatin1(option));
        return value.isEmpty() ? all : QStringList{value};
    };
    QStringList problems;
    if (!seesClippedWords()) {
        problems << QStringLiteral("A button too narrow for its word was not noticed");
    }
    int pictures = 0;
    for (const QString& language : chosen("language", ui::languages())) {
        for (const QString& theme : chosen("theme", {QStringLiteral("dark"), QStringLiteral("light")})) {
            test::Gallery gallery(folder, language, theme);
            if (parser.isSet(QStringLiteral("scan"))) {
                gallery.runScan(parser.value(QStringLiteral("scan")));
            } else {
                gallery.run();
            }
            problems << gallery.problems();
            pictures += gallery.pictureCount();
        }
    }
    QThreadPool::globalInstance()->waitForDone();
    std::printf("%d pictures, %d problems\n", pictures, static_cast<int>(problems.size()));
    for (const QString& problem : problems) {
        std::printf("%s\n", problem.toUtf8().constData());
    }
    return problems.isEmpty() && pictures > 0 ? 0 : 1;
}
