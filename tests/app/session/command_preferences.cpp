#include "app/files/autosave.h"
#include "io/case/case_file.h"
#include "tests/app/session/tool_preference.h"
#include "ui/views/angiogram_view.h"

#include <QDir>

#include <algorithm>
#include <array>

namespace angiopose::test {
namespace {

/// Setting names of the commands to avoid: those that quit, open or close a case, start another instance or overwrite
/// the opened case.
constexpr std::array leadingAway{"quit",       "open-", "open-dicom-folder-", "open-sample-case", "new-window",
                                 "close-case", "save"};

bool commandLeadsAway(const QAction& action)
{
    return std::ranges::any_of(leadingAway,
                               [&](const char* name) { return action.objectName() == QLatin1String(name); });
}

QString command(Desk& desk)
{
    const QList<QAction*> all = desk.window.QWidget::actions();
    QAction* action = desk.hand.oneOf(all);
    if (!action->isEnabled() || commandLeadsAway(*action)) {
        return {};
    }
    ui::AngiogramView& view = desk.window.angiogramView();
    view.setFocus();
    const QString name = QStringLiteral("command ") + action->objectName();
    if (action->shortcut().isEmpty() || desk.hand.oneIn(10)) {
        action->trigger();
    } else {
        desk.hand.press(view, action->shortcut());
    }
    return name;
}

QString handlePoses(Desk& desk)
{
    static constexpr std::array commands{ui::Command::TakeSnapshot, ui::Command::ToggleSnapshots,
                                         ui::Command::ComparePoses, ui::Command::AuxiliaryAdvice,
                                         ui::Command::BlindTrial,   ui::Command::FinishTrial,
                                         ui::Command::GantryAngles};
    QAction* action = desk.window.actions()[desk.hand.oneOf(commands)];
    action->trigger();
    return QStringLiteral("poses: ") + action->objectName();
}

QString saveAndExport(Desk& desk)
{
    desk.controller.saveController().saveTo(desk.folder + QStringLiteral("/random.angiopose"));
    desk.controller.exportController().exportOverlay({300 + desk.hand.below(500), ui::Toggle::On, ui::Toggle::Off},
                                                     desk.folder + QStringLiteral("/random.png"));
    return QStringLiteral("save and export");
}

/// Recovers a copy of the open case, as after a crash of an earlier session.
QString recover(Desk& desk)
{
    if (desk.controller.document().isInTrial() || desk.controller.isLoading()) {
        return {};
    }
    for (const app::RecoveryCopy& copy : app::Autosave::recoveryCopies()) {
        app::Autosave::forget(copy);
    }
    const QDir folder(desk.folder + QStringLiteral("/autosave"));
    folder.mkpath(QStringLiteral("."));
    const QString path = folder.filePath(QStringLiteral("session-999999.angiopose"));
    if (!io::saveCase(desk.controller.document().current(), path.toStdString())) {
        return {};
    }
    desk.controller.saveController().offerRecovery();
    return QStringLiteral("recovery");
}

}   // namespace

std::vector<ToolPreference> commandPreferences()
{
    return {{26, command}, {2, handlePoses}, {1, saveAndExport}, {1, recover}};
}

}   // namespace angiopose::test
