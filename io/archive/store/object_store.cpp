#include "io/archive/store/object_store.h"

#include "io/archive/model/query.h"
#include "io/messages/messages.h"
#include "io/study/study_file.h"
#include "io/support/own_leftovers.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours staleAfter{6};   // longer than any object takes to arrive

core::Error noFolder(const std::string& path, const std::error_code& why)
{
    return messages::archiveNoFolder(why.message()).about(path);
}

/// Returns a temporary path that identifies the process; a later process cleans up after one that was killed.
std::string temporaryPathIn(const fs::path& folder)
{
    std::random_device device;
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::string path = temporaryPatternFor((folder / "object").string());
    for (std::size_t at = path.size() - 6; at < path.size(); ++at) {
        path[at] = letters.at(device() % letters.size());
    }
    return path;
}

/// Creates a folder that only its owner can access, because it contains patient images.
core::Status makePrivateFolder(const fs::path& path)
{
    std::error_code failed;
    if (fs::is_directory(path, failed)) {
        return core::Done{};
    }
    fs::create_directories(path, failed);
    if (!failed) {
        fs::permissions(path, fs::perms::owner_all, failed);
    }
    return failed ? core::Status(noFolder(path.string(), failed)) : core::Status(core::Done{});
}

void dropStaleFiles(const fs::path& folder)
{
    std::error_code ignored;
    const auto now = fs::file_time_type::clock::now();
    for (fs::directory_iterator each(folder, ignored), end; !ignored && each != end; each.increment(ignored)) {
        std::error_code unknown;
        const auto written = fs::last_write_time(each->path(), unknown);
        if (!unknown && now - written > staleAfter) {
            fs::remove(each->path(), unknown);
        }
    }
}

bool isSameContent(const fs::path& one, const fs::path& other)
{
    std::ifstream a(one, std::ios::binary), b(other, std::ios::binary);
    std::array<char, 1 << 16> left{}, right{};
    while (a && b) {
        a.read(left.data(), left.size());
        b.read(right.data(), right.size());
        if (a.gcount() != b.gcount() || !std::equal(left.begin(), left.begin() + a.gcount(), right.begin())) {
            return false;
        }
    }
    return a.eof() && b.eof();
}

/// Removes the file on destruction unless it was moved.
class Remover {
public:
    explicit Remover(fs::path path) : path_(std::move(path)) {}
    Remover(const Remover&) = delete;
    Remover& operator=(const Remover&) = delete;
    ~Remover()
    {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }

private:
    fs::path path_;
};

/// Explains why a received object is not the expected one; returns nullopt if it matches.
std::optional<core::Message> explainMismatch(const core::StudyIdentity& came, const ExpectedObject& expected)
{
    const bool isOther = (!expected.studyUid.empty() && came.studyUid != expected.studyUid) ||
                         (!expected.seriesUid.empty() && came.seriesUid != expected.seriesUid) ||
                         (!expected.sopInstance.empty() && came.sopInstanceUid != expected.sopInstance);
    if (isOther) {
        return messages::archiveObjectForeign(came.sopInstanceUid);
    }
    if (!isUid(came.studyUid) || !isUid(came.seriesUid) || !isUid(came.sopInstanceUid)) {
        return messages::archiveObjectUnreadable();
    }
    return std::nullopt;
}

}   // namespace

IncomingObject::IncomingObject(std::string root, std::string temporary, AtomicFile file, std::uint64_t maxBytes)
    : root_(std::move(root)), temporary_(std::move(temporary)), file_(std::move(file)), maxBytes_(maxBytes)
{
}

core::Result<IncomingObject> IncomingObject::begin(const std::string& root, std::uint64_t maxBytes)
{
    const std::string temporary = temporaryPathIn(fs::path(root) / incomingFolder);
    auto file = AtomicFile::create(temporary);
    if (!file) {
        return file.error();
    }
    return IncomingObject(root, temporary, std::move(file).value(), maxBytes);
}

core::Status IncomingObject::write(std::string_view bytes)
{
    if (bytes.size() > maxBytes_ - bytes_) {
        isTooLarge_ = true;
        return core::Error(messages::archiveObjectTooLarge(sizeText(maxBytes_)));
    }
    bytes_ += bytes.size();
    return file_.write(bytes);
}

core::Result<StoredObject> IncomingObject::finish(const ExpectedObject& expected) &&
{
    if (auto committed = file_.commit(); !committed) {
        return committed.error();
    }
    const Remover remover(temporary_);
    const auto read = readStudyFile(temporary_);
    if (!read || !read.value()) {
        return core::Error(messages::archiveObjectUnreadable());
    }
    const core::StudyIdentity& identity = read.value()->images.identity;
    if (const auto mismatch = explainMismatch(identity, expected)) {
        return core::Error(*mismatch);
    }
    StoredObject stored;
    stored.bytes = bytes_;
    const fs::path folder = fs::path(root_) / identity.studyUid / identity.seriesUid;
    stored.folder = folder.string();
    stored.path = (folder / (identity.sopInstanceUid + ".dcm")).string();
    std::error_code failed;
    if (fs::exists(stored.path, failed)) {
        stored.kind =
            isSameContent(stored.path, temporary_) ? StoredObject::Kind::Duplicate : StoredObject::Kind::Conflict;
        return stored;
    }
    fs::create_directories(folder, failed);
    if (!failed) {
        fs::rename(temporary_, stored.path, failed);
    }
    return failed ? core::Result<StoredObject>(noFolder(stored.folder, failed)) : core::Result<StoredObject>(stored);
}

core::Result<ObjectStore> ObjectStore::open(const std::string& root, std::uint64_t maxObjectBytes)
{
    std::error_code unknown;
    const fs::path absolute = fs::absolute(root, unknown);
    if (unknown || root.empty()) {
        return noFolder(root, unknown);
    }
    for (const fs::path& folder : {absolute, absolute / incomingFolder}) {
        if (auto made = makePrivateFolder(folder); !made) {
            return made.error();
        }
    }
    removeLeftovers((absolute / incomingFolder).string());
    dropStaleFiles(absolute / incomingFolder);
    return ObjectStore(absolute.string(), maxObjectBytes);
}

std::string ObjectStore::seriesFolder(const std::string& studyUid, const std::string& seriesUid) const
{
    return (fs::path(root_) / studyUid / seriesUid).string();
}

std::optional<std::uint64_t> ObjectStore::storedSize(const ExpectedObject& object) const
{
    std::error_code missing;
    const auto size = fs::file_size(
        fs::path(seriesFolder(object.studyUid, object.seriesUid)) / (object.sopInstance + ".dcm"), missing);
    return missing ? std::nullopt : std::optional<std::uint64_t>(size);
}

}   // namespace angiopose::io
