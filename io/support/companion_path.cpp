#include "io/support/companion_path.h"

namespace angiopose::io {

std::filesystem::path companionPath(const std::filesystem::path& casePath, const CompanionName& name,
                                    const std::filesystem::path& own)
{
    const std::string view = name.otherView ? ".view-" + std::to_string(*name.otherView + 2) : std::string();
    const std::string stem = casePath.stem().string() + view + "." + name.kind;
    for (int number = 1;; ++number) {
        const std::string numbered = number == 1 ? stem : stem + "-" + std::to_string(number);
        std::filesystem::path path = (casePath.parent_path() / (numbered + "." + name.extension)).lexically_normal();
        std::error_code absent;
        if (path == own || !std::filesystem::exists(path, absent)) {
            return path;
        }
    }
}

}   // namespace angiopose::io
