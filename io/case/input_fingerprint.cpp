#include "io/case/input_fingerprint.h"

#include "io/file_hash.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

void addFile(InputFingerprint& facts, const fs::path& file)
{
    std::error_code failed;
    const auto size = fs::file_size(file, failed);
    const auto modificationTime = fs::last_write_time(file, failed);
    if (!failed) {
        facts.size += size;
        facts.modificationTime = std::max<std::int64_t>(
            facts.modificationTime, static_cast<std::int64_t>(modificationTime.time_since_epoch().count()));
    }
}

}   // namespace

InputFingerprint inputFingerprint(const std::string& path, const std::string& sha256)
{
    InputFingerprint facts;
    facts.path = path;
    facts.sha256 = sha256;
    facts.modificationTime = std::numeric_limits<std::int64_t>::min();
    std::error_code failed;
    facts.isPresent = fs::exists(path, failed);
    if (fs::is_directory(path, failed)) {
        for (const auto& entry : fs::directory_iterator(path, failed)) {
            addFile(facts, entry.path());
        }
    } else if (facts.isPresent) {
        addFile(facts, path);
    }
    return facts;
}

bool isUnchanged(const InputFingerprint& known)
{
    const InputFingerprint now = inputFingerprint(known.path, known.sha256);
    if (now == known) {
        return true;
    }
    if (now.isPresent != known.isPresent || now.size != known.size || known.sha256.empty()) {
        return false;
    }
    const auto content = sha256OfFile(known.path);
    return content && content.value() == known.sha256;
}

}   // namespace angiopose::io
