#include "app/files/recent_controller.h"

#include "app/files/case_pictures.h"
#include "app/files/recent_cases.h"
#include "app/messages/says.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/welcome_page.h"
#include "ui/words/spoken.h"

#include <QFileInfo>
#include <QMenu>

#include <utility>

namespace angiopose::app {
namespace {

ui::RecentCase::State stateOf(CasePresence state)
{
    switch (state) {
        case CasePresence::Missing:
            return ui::RecentCase::State::Missing;
        case CasePresence::InputsMissing:
            return ui::RecentCase::State::InputsMissing;
        case CasePresence::Present:
            break;
    }
    return ui::RecentCase::State::Present;
}

}   // namespace

RecentController::RecentController(const CaseDocument& document, const Ui& ui, CaseLookup::Look look, QObject* parent)
    : QObject(parent), document_(document), ui_(ui), lookup_(std::move(look))
{
    const ui::RecentList& list = ui_.welcome.recent();
    connect(&list, &ui::RecentList::openRequested, this, &RecentController::openRequested);
    // What asks for these goes away with the list.
    connect(&list, &ui::RecentList::clearRequested, this, &RecentController::clear, Qt::QueuedConnection);
    connect(
        &list, &ui::RecentList::removeRequested, this,
        [this](const QString& path) {
            forgetCase(path);
            show();
        },
        Qt::QueuedConnection);
    connect(
        &list, &ui::RecentList::pinToggled, this,
        [this](const QString& path, bool pinned) {
            setPinned(path, pinned);
            show();
        },
        Qt::QueuedConnection);
    connect(&list, &ui::RecentList::picturesToggled, this, &RecentController::setPictures, Qt::QueuedConnection);
    connect(&lookup_, &CaseLookup::found, this, &RecentController::take);
    connect(&lookup_, &CaseLookup::told, this, &RecentController::showNews);
    ui::speak(this, [this] { fill(); });
}

void RecentController::fill()
{
    show();
    lookup_.look(recentCases());
}

void RecentController::show()
{
    const QStringList cases = recentCases();
    const bool hasPictures = settings::recentPictures.read();
    std::vector<ui::RecentCase> rows;
    for (const QString& path : cases) {
        const Known known = known_.value(path);
        rows.push_back({path, hasPictures ? known.picture : QImage(), stateOf(known.state), isPinned(path)});
    }
    ui_.welcome.recent().showCases(rows, hasPictures);
    fillMenu(cases);
}

void RecentController::fillMenu(const QStringList& cases)
{
    QMenu* menu = ui_.actions.recentMenu();
    menu->clear();
    const bool hasPictures = settings::recentPictures.read();
    for (const QString& path : cases) {
        const Known known = known_.value(path);
        QAction* action = menu->addAction(ui::RecentList::labelOf(path, stateOf(known.state)));
        action->setToolTip(path);
        action->setEnabled(known.state != CasePresence::Missing);
        if (hasPictures && !known.picture.isNull()) {
            action->setIcon(QIcon(QPixmap::fromImage(known.picture)));
        }
        connect(action, &QAction::triggered, this, [this, path] { emit openRequested(path); });
    }
    menu->setEnabled(!menu->isEmpty());
    if (!menu->isEmpty()) {
        menu->addSeparator();
        menu->addAction(tr("Clear the list"), this, &RecentController::clear);
    }
}

void RecentController::take(const QString& path, const CaseLook& look)
{
    Known& known = known_[path];
    const QImage picture = QImage::fromData(QByteArray::fromStdString(look.picture));
    isNews_ = isNews_ || known.state != look.state || known.picture != picture;
    known = {look.state, picture};
}

/// Rows are made anew only where there is something new to say: one may be under the mouse.
void RecentController::showNews()
{
    if (std::exchange(isNews_, false)) {
        show();
    }
}

void RecentController::clear()
{
    forgetRecentCases();
    show();
}

/// Pictures that are not wanted are not kept either.
void RecentController::setPictures(bool wanted)
{
    settings::recentPictures.write(wanted);
    if (!wanted) {
        keepCasePictures({});
        known_.clear();
    }
    fill();
}

void RecentController::pictureOpened()
{
    const QString path = document_.path();
    if (path.isEmpty() || isPrivate() || !settings::recentPictures.read()) {
        return;
    }
    pictures_.run(
        [snapshot = document_.current(), path]() -> core::Result<QString> {
            if (!storeCasePicture(snapshot, path)) {
                return core::Error(says::notShown());
            }
            return path;
        },
        [this](const core::Result<QString>& stored) {
            keepCasePictures(settings::recentPictures.read() ? recentCases() : QStringList());   // as is wanted by now
            if (stored) {
                fill();
            }
        });
}

}   // namespace angiopose::app
