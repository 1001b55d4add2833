#include "io/decode/helper_program.h"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

/// The program or the shared library that this function is in.
fs::path ownBinary()
{
    Dl_info info{};
    link_map* map = nullptr;
    const bool isFound = ::dladdr1(reinterpret_cast<const void*>(&ownBinary), &info, reinterpret_cast<void**>(&map),
                                   RTLD_DL_LINKMAP) != 0;
    const bool isLibrary = isFound && map != nullptr && map->l_name[0] != '\0';   // a program has no name there
    std::error_code ignored;
    return isLibrary ? fs::canonical(map->l_name, ignored) : fs::read_symlink("/proc/self/exe", ignored);
}

}   // namespace

std::string helperProgram(const std::string& name)
{
    // PREFIX/bin/angiopose, PREFIX/lib/libangiopose.so or PREFIX/lib/x86_64-linux-gnu/libangiopose.so.
    const fs::path folder = ownBinary().parent_path();
    for (const fs::path& prefix : {folder.parent_path(), folder.parent_path().parent_path()}) {
        const fs::path candidate = prefix / ANGIOPOSE_HELPER_FOLDER / name;
        if (!prefix.empty() && ::access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
    }
    // A package of the library alone keeps its own beside it.
    const fs::path beside = folder / "angiopose" / name;
    return ::access(beside.c_str(), X_OK) == 0 ? beside : fs::path(ANGIOPOSE_INSTALLED_HELPERS) / name;
}

}   // namespace angiopose::io
