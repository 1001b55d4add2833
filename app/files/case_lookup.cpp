#include "app/files/case_lookup.h"

#include "app/files/case_pictures.h"
#include "io/case/moved_inputs.h"

#include <QFileInfo>

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
constexpr auto graceAtEnd = std::chrono::milliseconds(200);   // for those that are about to be done
constexpr std::uintmax_t maxPictureBytes = 1 << 20;

struct Asked {
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

/// See storeCasePicture.
bool isOfSameTime(const std::string& casePath, const std::string& picturePath)
{
    std::error_code failed, alsoFailed;
    const auto ofCase = std::filesystem::last_write_time(casePath, failed);
    const auto ofPicture = std::filesystem::last_write_time(picturePath, alsoFailed);
    return !failed && !alsoFailed && ofCase == ofPicture;
}

}   // namespace

CaseLook lookAtCase(const std::string& casePath, const std::string& picturePath)
{
    std::error_code failed;
    if (!std::filesystem::is_regular_file(casePath, failed)) {
        return {CasePresence::Missing, {}};
    }
    const auto missing = io::missingInputs(casePath);   // a case that cannot be read says so when it is opened
    const bool isWhole = !missing || missing.value().empty();
    return {isWhole ? CasePresence::Present : CasePresence::InputsMissing,
            isOfSameTime(casePath, picturePath) ? contentOf(picturePath) : std::string()};
}

/// What the threads and the window share; outlives both.
struct CaseLookup::Shared {
    std::mutex mutex;
    std::condition_variable ended;
    int threads = 0;
    std::set<QString> underWay;
    std::set<QString> askedAgain;   ///< since: what was seen may be of before
    std::vector<std::pair<QString, CaseLook>> answers;

    void answer(const Asked& asked, const Look& look)
    {
        for (bool isNews = true; isNews;) {
            CaseLook found = look(asked.casePath, asked.picturePath);
            const std::lock_guard lock(mutex);
            isNews = askedAgain.erase(asked.path) > 0;
            if (!isNews) {
                answers.emplace_back(asked.path, std::move(found));
                underWay.erase(asked.path);
            }
        }
    }
};

CaseLookup::CaseLookup(Look look, QObject* parent)
    : QObject(parent), look_(std::move(look)), shared_(std::make_shared<Shared>())
{
    poll_.setInterval(pollMs);
    connect(&poll_, &QTimer::timeout, this, &CaseLookup::publish);
}

CaseLookup::~CaseLookup()
{
    std::unique_lock lock(shared_->mutex);
    shared_->ended.wait_for(lock, graceAtEnd, [this] { return shared_->threads == 0; });
}

void CaseLookup::look(const QStringList& paths)
{
    std::map<QString, std::vector<Asked>> byFolder;
    {
        const std::lock_guard lock(shared_->mutex);
        for (const QString& path : paths) {
            if (!shared_->underWay.insert(path).second) {
                shared_->askedAgain.insert(path);
            } else {
                byFolder[QFileInfo(path).path()].push_back(
                    {path, path.toStdString(), casePicturePath(path).toStdString()});
            }
        }
        shared_->threads += static_cast<int>(byFolder.size());
    }
    for (auto& [folder, asked] : byFolder) {
        std::thread([shared = shared_, look = look_, asked = std::move(asked)] {
            for (const Asked& each : asked) {
                shared->answer(each, look);
            }
            const std::lock_guard lock(shared->mutex);
            --shared->threads;
            shared->ended.notify_all();
        }).detach();
    }
    poll_.start();
}

void CaseLookup::publish()
{
    std::vector<std::pair<QString, CaseLook>> answers;
    bool isDone = false;
    {
        const std::lock_guard lock(shared_->mutex);
        answers.swap(shared_->answers);
        isDone = shared_->threads == 0;
    }
    if (isDone) {
        poll_.stop();
    }
    for (const auto& [path, look] : answers) {
        emit found(path, look);
    }
    if (!answers.empty()) {
        emit told();
    }
}

}   // namespace angiopose::app
