#include "tests/app/gallery/gallery.h"

#include "app/case_controller.h"
#include "app/files/sample_case.h"
#include "tests/app/gallery/clipped_texts.h"
#include "ui/theme/active_theme.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QImage>
#include <QSet>
#include <QTest>

#include <array>
#include <utility>

namespace test {
namespace {

constexpr int patienceMs = 120000;

/// A picture of hardly any colours shows nothing.
bool isEmpty(const QImage& picture)
{
    QSet<QRgb> colors;
    for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) {
            colors.insert(picture.pixel(x, y));
        }
    }
    return colors.size() < 4;
}

void openSample(app::CaseController& controller)
{
    const auto sample = app::writeSampleCase();
    if (sample) {
        controller.open({sample.value()});
    }
    if (!QTest::qWaitFor([&controller] { return !controller.isLoading() && controller.judgement() != nullptr; },
                         patienceMs)) {
        qFatal("The sample case did not open.");
    }
}

void runRegistration(app::CaseController& controller)
{
    controller.registration().start();
    if (!QTest::qWaitFor([&controller] { return !controller.registration().isRunning(); }, patienceMs)) {
        qFatal("The registration did not end.");
    }
    QTest::qWait(300);
}

void unfoldAll(QWidget& window)
{
    for (ui::Section* section : window.findChildren<ui::Section*>()) {
        section->setFolded(false);
    }
    QTest::qWait(50);
}

}   // namespace

Gallery::Gallery(QString folder, QString language, QString theme)
    : folder_(std::move(folder)), language_(std::move(language)), theme_(std::move(theme))
{
    ui::applyTheme(*qApp, theme_ == QLatin1String("light") ? ui::ThemeMode::Light : ui::ThemeMode::Dark);
    ui::applyLanguage(language_);
}

void Gallery::run()
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1440, 900);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) {
        qFatal("The window did not show.");
    }
    showWindow(window, QStringLiteral("welcome"));
    openSample(controller);
    showWindow(window, QStringLiteral("start"));
    runRegistration(controller);
    showWindow(window, QStringLiteral("registered"));
    window.resize(1024, 720);
    showWindow(window, QStringLiteral("small"));
    window.resize(1440, 900);
    unfoldAll(window);
    showPanels(window);
    const std::array dialogs{std::pair{ui::Command::Keys, "keys"}, std::pair{ui::Command::About, "about"},
                             std::pair{ui::Command::ExportOverlay, "export"}, std::pair{ui::Command::PanelHelp, "help"},
                             std::pair{ui::Command::GoodFit, "good_fit"}};
    for (const auto& [command, name] : dialogs) {
        window.actions()[command]->trigger();
        QTest::qWait(200);
        for (QDialog* dialog : window.findChildren<QDialog*>()) {
            if (dialog->isVisible()) {
                showWindow(*dialog, QString::fromLatin1(name));
                dialog->reject();
            }
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

void Gallery::showWindow(QWidget& window, const QString& name)
{
    QTest::qWait(150);
    take(window, name);
    for (const QString& problem : clippedTexts(window)) {
        problems_ << QStringLiteral("%1, %2, %3: %4").arg(language_, theme_, name, problem);
    }
}

void Gallery::showPanels(QWidget& window)
{
    QSet<QString> names;
    for (ui::Section* section : window.findChildren<ui::Section*>()) {
        if (!section->isVisible()) {
            continue;
        }
        QString name = QString::fromLatin1(section->metaObject()->className()).section(QStringLiteral("::"), -1);
        while (names.contains(name)) {
            name += QLatin1Char('_');
        }
        names.insert(name);
        showWindow(*section, name);
    }
}

void Gallery::take(QWidget& widget, const QString& name)
{
    const QImage picture = widget.grab().toImage();
    ++pictureCount_;
    if (isEmpty(picture)) {
        problems_ << QStringLiteral("%1, %2: %3 shows nothing").arg(language_, theme_, name);
    }
    if (!folder_.isEmpty()) {
        const QString file = QStringLiteral("%1_%2_%3.png").arg(name, language_, theme_);
        picture.save(QDir(folder_).filePath(file));
    }
}

}   // namespace test
