#pragma once

#include "core/support/result.h"

#include <filesystem>
#include <string>

namespace angiopose::io {

/// Temporary folder next to the target file and hence on the same drive; the destructor removes it.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& targetFile);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    core::Status make() const;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}   // namespace angiopose::io
