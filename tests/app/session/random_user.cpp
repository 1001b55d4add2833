#include "tests/app/session/random_user.h"

#include "app/files/autosave.h"
#include "app/preferences/settings.h"
#include "tests/app/wait_for.h"
#include "ui/views/angiogram_view.h"

#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QStandardPaths>
#include <QTest>

namespace angiopose::test {
namespace {

constexpr int maxDialogs = 5;   // one dialog may open another

QWidget* openDialog(const QWidget& window)
{
    if (QWidget* popup = QApplication::activePopupWidget()) {
        return popup;
    }
    QWidget* open = nullptr;
    for (QDialog* dialog : window.findChildren<QDialog*>()) {
        open = dialog->isVisible() ? dialog : open;
    }
    return open;
}

}   // namespace

RandomUser::RandomUser(app::WindowHost& host, std::uint64_t seed)
    : host_(host),
      hand_(seed),
      folder_(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)),
      layout_(host.window().layoutState())
{
    app::settings::trialLog.write(folder_ + QStringLiteral("/trials.csv"));
    app::settings::lastFolder.write(folder_);
    for (const auto& some : {imagePreferences(), vesselPreferences(), panelPreferences(), commandPreferences()}) {
        preferences_.insert(preferences_.end(), some.begin(), some.end());
    }
    for (const ToolPreference& preference : preferences_) {
        totalWeight_ += preference.weight;
    }
}

Desk RandomUser::desk()
{
    return {host_.window(), host_.controller(), hand_, folder_};
}

QString RandomUser::doSomething()
{
    Desk here = desk();
    int draw = hand_.below(totalWeight_);
    for (const ToolPreference& preference : preferences_) {
        draw -= preference.weight;
        if (draw < 0) {
            return preference.act(here);
        }
    }
    return {};
}

void RandomUser::act()
{
    last_ = doSomething();
    QApplication::processEvents();
    QWidget* dialog = openDialog(host_.window());
    if (dialog && !qobject_cast<QFileDialog*>(dialog)) {
        workIn(*dialog, hand_);
        QApplication::processEvents();
    }
    closeDialogs();
}

void RandomUser::closeDialogs()
{
    for (int round = 0; round < maxDialogs; ++round) {
        QWidget* open = openDialog(host_.window());
        if (!open) {
            return;
        }
        QTest::keyClick(open, Qt::Key_Escape);
        if (open->isVisible()) {
            open->close();
        }
        QApplication::processEvents();
    }
}

/// Restores the initial layout, language and theme: view sizes and language are not part of the comparison. The images
/// of large views alone take tens of MiB.
void RandomUser::putWindowBack()
{
    using enum ui::Command;
    ui::MainWindow& window = host_.window();
    for (const ui::Command command :
         {FullScreen, ImageOnly, CornerOnly, ImageWindow, CornerWindow, SlicesLarge, Cine, Replay, Swing, Flicker}) {
        window.actions()[command]->setChecked(false);
    }
    window.showNormal();
    window.restoreLayout(layout_);
    window.actions()[LanguageEnglish]->trigger();
    window.actions()[ThemeDark]->trigger();
    QTest::qWait(1000);
}

bool RandomUser::comeToRest()
{
    closeDialogs();
    const auto isAtRest = [this] {
        app::CaseController& controller = host_.controller();
        return !controller.isBusy() && !controller.target().isTracing();
    };
    host_.window().angiogramView().setTool(nullptr);
    host_.controller().registration().stop();
    host_.controller().poses().blindTrial().abandon();
    for (const app::RecoveryCopy& copy : app::Autosave::recoveryCopies()) {
        app::Autosave::forget(copy);   // recoveries that were postponed
    }
    putWindowBack();
    const bool hasEnded = test::waitFor(isAtRest);
    QTest::qWait(1000);   // assessments, subtractions and snapshots in progress
    return hasEnded;
}

}   // namespace angiopose::test
