#include "io/case/fields/file_fields.h"

namespace angiopose::io {

core::InputFile fileFrom(const Json& json)
{
    return {json.value("path", ""), json.value("sha256", "")};
}

Json fileJson(const core::InputFile& file, const std::filesystem::path& folder)
{
    if (file.path.empty()) {
        return {};
    }
    std::error_code failed;
    const std::filesystem::path target = std::filesystem::weakly_canonical(file.path, failed);
    const std::filesystem::path relative = target.lexically_relative(folder);
    Json json;
    json["path"] = (failed || relative.empty() ? std::filesystem::path(file.path) : relative).generic_string();
    if (!file.sha256.empty()) {
        json["sha256"] = file.sha256;
    }
    return json;
}

}   // namespace angiopose::io
