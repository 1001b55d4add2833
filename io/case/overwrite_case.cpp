#include "io/case/overwrite_case.h"

#include "io/case/case_file.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/support/case_lock.h"
#include "io/support/file_error.h"

#include <filesystem>

namespace angiopose::io {

std::string caseFileHash(const std::string& path)
{
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) {
        return {};
    }
    const auto hash = sha256OfFile(path);
    return hash ? hash.value() : std::string();
}

core::Result<std::string> overwriteCase(const core::Case& session, const std::string& path,
                                        const std::string& knownSha256)
{
    const FolderLock turn(std::filesystem::absolute(path).parent_path().string());
    const std::string there = knownSha256.empty() ? std::string() : caseFileHash(path);
    if (!there.empty() && there != knownSha256) {   // a deleted file is simply written again
        return fileError(path, messages::caseChangedElsewhere());
    }
    if (const auto saved = saveCase(session, path); !saved) {
        return saved.error();
    }
    return caseFileHash(path);
}

bool isConcurrentChange(const core::Error& error)
{
    return error.message.is(messages::caseChangedElsewhere);
}

}   // namespace angiopose::io
