#pragma once

#include "io/support/system/held_file.h"

#include <string>

namespace angiopose::io {

/// While it lives no other `FolderTurn` of the folder does, in this program or another: waits for it, two seconds at
/// most. Without effect where the file system knows no such locks.
class FolderTurn {
public:
    explicit FolderTurn(const std::string& folder);

private:
    HeldFile folder_;
};

}   // namespace angiopose::io
