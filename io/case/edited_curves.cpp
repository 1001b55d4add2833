#include "io/case/edited_curves.h"

#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/support/input_bytes.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The curves that the case file, as it is now, calls its own; empty when there are none.
fs::path ownCurves(const fs::path& casePath)
{
    const auto input = openInput(casePath.string());
    const Json root = input ? Json::parse(input.value().view(), nullptr, false) : Json();
    const Json centerline = root.is_object() ? root.value("angiogram", Json()).value("centerline", Json()) : Json();
    if (!centerline.is_object() || centerline.value("origin", "") != "edited") {
        return {};
    }
    return (casePath.parent_path() / centerline.value("path", "")).lexically_normal();
}

fs::path freePath(const fs::path& casePath)
{
    const fs::path own = ownCurves(casePath);
    const std::string stem = casePath.stem().string() + ".curves";
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? stem : stem + "-" + std::to_string(number);
        fs::path path = (casePath.parent_path() / (name + ".csv")).lexically_normal();
        std::error_code absent;
        if (path == own || !fs::exists(path, absent)) {
            return path;
        }
    }
}

}   // namespace

core::Result<core::InputFile> keepEditedCurves(const core::RegistrationCase& registrationCase,
                                               const std::string& casePath)
{
    const core::InputFile& former = registrationCase.targetFile;
    if (!former.path.empty() && former.path == ownCurves(fs::absolute(casePath)).string()) {
        return former;
    }
    const std::string path = freePath(fs::absolute(casePath)).string();
    if (const auto written = writeCenterline2d(*registrationCase.givenTarget, path); !written) {
        return written.error();
    }
    auto hash = sha256OfFile(path);
    return hash ? core::Result<core::InputFile>(core::InputFile{path, std::move(hash).value()}) : hash.error();
}

}   // namespace io
