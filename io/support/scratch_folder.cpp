#include "io/support/scratch_folder.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <array>
#include <cstdio>
#include <random>

namespace angiopose::io {

ScratchFolder::ScratchFolder(const std::string& targetFile)
{
    std::random_device random;
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), ".angiopose-%08x%08x", random(), random());
    path_ = std::filesystem::absolute(targetFile).parent_path() / name.data();
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

core::Status ScratchFolder::make() const
{
    std::error_code failed;
    std::filesystem::create_directory(path_, failed);
    if (!failed) {
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, failed);
    }
    return failed ? core::Status(fileError(path_.string(), messages::fileNotWritten(failed.message()))) : core::Done{};
}

}   // namespace angiopose::io
