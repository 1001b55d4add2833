#pragma once

#include "core/support/result.h"

#include <filesystem>
#include <string>

namespace angiopose::io {

/// A folder for what goes into one file, beside that file, where there is room for it; gone with this.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& besideFile);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    core::Status make() const;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}   // namespace angiopose::io
