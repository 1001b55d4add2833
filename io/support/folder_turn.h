#pragma once

#include <string>

namespace angiopose::io {

/// While it lives no other `FolderTurn` of the folder does, in this program or another: waits for it, two seconds at
/// most. Without effect where the file system knows no such locks.
class FolderTurn {
public:
    explicit FolderTurn(const std::string& folder);
    FolderTurn(const FolderTurn&) = delete;
    FolderTurn& operator=(const FolderTurn&) = delete;
    ~FolderTurn();

private:
    int folder_ = -1;
};

}   // namespace angiopose::io
