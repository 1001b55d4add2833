#include "io/decode/helper_program.h"

#include "io/support/system/own_process.h"

#include <filesystem>

namespace angiopose::io {

std::string helperProgram(const std::string& name)
{
    namespace fs = std::filesystem;
    // PREFIX/bin/angiopose, PREFIX/lib/libangiopose.so or PREFIX/lib/x86_64-linux-gnu/libangiopose.so.
    const fs::path folder = ownBinary().parent_path();
    for (const fs::path& prefix : {folder.parent_path(), folder.parent_path().parent_path()}) {
        const fs::path candidate = prefix / ANGIOPOSE_HELPER_FOLDER / name;
        if (!prefix.empty() && isExecutable(candidate)) {
            return candidate;
        }
    }
    // A package of the library alone keeps its own beside it.
    const fs::path beside = folder / "angiopose" / name;
    return isExecutable(beside) ? beside : fs::path(ANGIOPOSE_INSTALLED_HELPERS) / name;
}

}   // namespace angiopose::io
