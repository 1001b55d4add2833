#include "app/files/recent_controller.h"

#include "app/files/recent_cases.h"
#include "app/messages/messages.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "io/case/moved_inputs.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/welcome_page.h"
#include "ui/words/retranslation.h"

#include <QFileInfo>
#include <QMenu>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace angiopose::app {
namespace {

constexpr int pollMs = 33;
constexpr auto graceAtEnd = std::chrono::milliseconds(200);   // waits for threads that are about to finish
constexpr std::uintmax_t maxPictureBytes = 1 << 20;

struct CheckRequest {
    QString path;
    std::string casePath, picturePath;
};

std::string contentOf(const std::string& path)
{
    std::error_code failed;
    const auto size = std::filesystem::file_size(path, failed);
    if (failed || size > maxPictureBytes) {
        return {};
    }
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns whether the thumbnail has the time stamp of the case file.
bool hasSameTimestamp(const std::string& casePath, const std::string& picturePath)
{
    std::error_code failed, alsoFailed;
    const auto ofCase = std::filesystem::last_write_time(casePath, failed);
    const auto ofPicture = std::filesystem::last_write_time(picturePath, alsoFailed);
    return !failed && !alsoFailed && ofCase == ofPicture;
}

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

RecentCaseStatus checkRecentCase(const std::string& casePath, const std::string& picturePath)
{
    std::error_code failed;
    if (!std::filesystem::is_regular_file(casePath, failed)) {
        return {CasePresence::Missing, {}};
    }
    const auto missing =
        io::findMissingInputs(casePath);   // fails for an unreadable case, which is reported when the case is opened
    const bool isWhole = !missing || missing.value().empty();
    return {isWhole ? CasePresence::Present : CasePresence::InputsMissing,
            hasSameTimestamp(casePath, picturePath) ? contentOf(picturePath) : std::string()};
}

/// State that the threads share with the checker; exists as long as any of them.
struct RecentCaseChecker::Shared {
    std::mutex mutex;
    std::condition_variable ended;
    int threads = 0;
    std::set<QString> underWay;
    std::set<QString> askedAgain;   ///< cases requested again during a check, whose result may then be outdated
    std::vector<std::pair<QString, RecentCaseStatus>> answers;

    void answer(const CheckRequest& asked, const CheckFunction& check)
    {
        for (bool isNews = true; isNews;) {
            RecentCaseStatus found = check(asked.casePath, asked.picturePath);
            const std::lock_guard lock(mutex);
            isNews = askedAgain.erase(asked.path) > 0;
            if (!isNews) {
                answers.emplace_back(asked.path, std::move(found));
                underWay.erase(asked.path);
            }
        }
    }
};

RecentCaseChecker::RecentCaseChecker(CheckFunction check, QObject* parent)
    : QObject(parent), check_(std::move(check)), shared_(std::make_shared<Shared>())
{
    poll_.setInterval(pollMs);
    connect(&poll_, &QTimer::timeout, this, &RecentCaseChecker::publish);
}

RecentCaseChecker::~RecentCaseChecker()
{
    std::unique_lock lock(shared_->mutex);
    shared_->ended.wait_for(lock, graceAtEnd, [this] { return shared_->threads == 0; });
}

void RecentCaseChecker::check(const QStringList& paths)
{
    std::map<QString, std::vector<CheckRequest>> byFolder;
    {
        const std::lock_guard lock(shared_->mutex);
        for (const QString& path : paths) {
            if (!shared_->underWay.insert(path).second) {
                shared_->askedAgain.insert(path);
            } else {
                byFolder[QFileInfo(path).path()].push_back(
                    {path, path.toStdString(), caseThumbnailPath(path).toStdString()});
            }
        }
        shared_->threads += static_cast<int>(byFolder.size());
    }
    for (auto& [folder, asked] : byFolder) {
        std::thread([shared = shared_, check = check_, asked = std::move(asked)] {
            for (const CheckRequest& request : asked) {
                shared->answer(request, check);
            }
            const std::lock_guard lock(shared->mutex);
            --shared->threads;
            shared->ended.notify_all();
        }).detach();
    }
    poll_.start();
}

void RecentCaseChecker::publish()
{
    std::vector<std::pair<QString, RecentCaseStatus>> answers;
    bool isDone = false;
    {
        const std::lock_guard lock(shared_->mutex);
        answers.swap(shared_->answers);
        isDone = shared_->threads == 0;
    }
    if (isDone) {
        poll_.stop();
    }
    for (const auto& [path, check] : answers) {
        emit found(path, check);
    }
    if (!answers.empty()) {
        emit reported();
    }
}

RecentController::RecentController(const CaseDocument& document, const Ui& ui, RecentCaseChecker::CheckFunction check,
                                   QObject* parent)
    : QObject(parent), document_(document), ui_(ui), checker_(std::move(check))
{
    const ui::RecentList& list = ui_.welcome.recent();
    connect(&list, &ui::RecentList::openRequested, this, &RecentController::openRequested);
    // Queued, because the slots delete the widgets that emit these signals.
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
    connect(&list, &ui::RecentList::thumbnailsToggled, this, &RecentController::setThumbnailsShown,
            Qt::QueuedConnection);
    connect(&checker_, &RecentCaseChecker::found, this, &RecentController::updateCase);
    connect(&checker_, &RecentCaseChecker::reported, this, &RecentController::showUpdates);
    ui::keepTranslated(this, [this] { rebuild(); });
}

void RecentController::rebuild()
{
    show();
    checker_.check(recentCases());
}

void RecentController::show()
{
    const QStringList cases = recentCases();
    const bool hasThumbnails = settings::recentThumbnails.read();
    std::vector<ui::RecentCase> rows;
    for (const QString& path : cases) {
        const KnownCase known = knownCases_.value(path);
        rows.push_back({path, hasThumbnails ? known.picture : QImage(), stateOf(known.state), isPinned(path)});
    }
    ui_.welcome.recent().showCases(rows, hasThumbnails);
    fillMenu(cases);
}

void RecentController::fillMenu(const QStringList& cases)
{
    QMenu* menu = ui_.actions.recentMenu();
    menu->clear();
    const bool hasThumbnails = settings::recentThumbnails.read();
    for (const QString& path : cases) {
        const KnownCase known = knownCases_.value(path);
        QAction* action = menu->addAction(ui::RecentList::labelOf(path, stateOf(known.state)));
        action->setToolTip(path);
        action->setEnabled(known.state != CasePresence::Missing);
        if (hasThumbnails && !known.picture.isNull()) {
            action->setIcon(QIcon(QPixmap::fromImage(known.picture)));
        }
        connect(action, &QAction::triggered, this, [this, path] { emit openRequested(path); });
    }
    menu->setEnabled(!menu->isEmpty());
    if (!menu->isEmpty()) {
        menu->addSeparator();
        menu->addAction(tr("Clear list"), this, &RecentController::clear);
    }
}

void RecentController::updateCase(const QString& path, const RecentCaseStatus& check)
{
    KnownCase& known = knownCases_[path];
    const QImage picture = QImage::fromData(QByteArray::fromStdString(check.picture));
    hasUpdates_ = hasUpdates_ || known.state != check.state || known.picture != picture;
    known = {check.state, picture};
}

/// Rebuilds the rows only if something has changed, since the mouse may be over one of them.
void RecentController::showUpdates()
{
    if (std::exchange(hasUpdates_, false)) {
        show();
    }
}

void RecentController::clear()
{
    forgetRecentCases();
    show();
}

/// Switches thumbnails on or off; switching them off deletes those that are stored.
void RecentController::setThumbnailsShown(bool enabled)
{
    settings::recentThumbnails.write(enabled);
    if (!enabled) {
        pruneCaseThumbnails({});
        knownCases_.clear();
    }
    rebuild();
}

void RecentController::makeThumbnail()
{
    const QString path = document_.path();
    if (path.isEmpty() || isPrivate() || !settings::recentThumbnails.read()) {
        return;
    }
    thumbnails_.run(
        [snapshot = document_.current(), path]() -> core::Result<QString> {
            if (!storeCaseThumbnail(snapshot, path)) {
                return core::Error(messages::notShown());
            }
            return path;
        },
        [this](const core::Result<QString>& stored) {
            pruneCaseThumbnails(settings::recentThumbnails.read() ? recentCases()
                                                                  : QStringList());   // as in the current setting
            if (stored) {
                rebuild();
            }
        });
}

}   // namespace angiopose::app
