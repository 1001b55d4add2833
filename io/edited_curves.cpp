#include "io/edited_curves.h"

#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/support/companion_path.h"
#include "io/support/input_bytes.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Owner of the curves: the shown view, which is stored in the case itself, or another view.
struct Owner {
    fs::path casePath;
    std::optional<std::size_t> otherView;
};

Json viewIn(const Json& root, std::optional<std::size_t> otherView)
{
    if (!otherView || !root.is_object()) {
        return root;
    }
    const Json views = root.value("views", Json::array());
    return views.is_array() && *otherView < views.size() ? views[*otherView] : Json();
}

/// Returns the curve file that the case file on disk names; empty if it names none.
fs::path ownCurves(const Owner& owner)
{
    const fs::path& casePath = owner.casePath;
    const auto input = openInput(casePath.string());
    const Json view = viewIn(input ? Json::parse(input.value().view(), nullptr, false) : Json(), owner.otherView);
    const Json angiogram = view.is_object() ? view.value("angiogram", Json::object()) : Json::object();
    const Json centerline = angiogram.is_object() ? angiogram.value("centerline", Json()) : Json();
    if (!centerline.is_object() || centerline.value("origin", "") != "edited") {
        return {};
    }
    return (casePath.parent_path() / centerline.value("path", "")).lexically_normal();
}

}   // namespace

core::Result<core::InputFile> saveEditedCurves(const core::GivenTarget& target, const std::string& casePath,
                                               std::optional<std::size_t> otherView)
{
    const Owner owner{fs::absolute(casePath), otherView};
    const core::InputFile& former = target.file;
    if (!former.path.empty() && former.path == ownCurves(owner).string()) {
        return former;
    }
    const std::string path = companionPath(owner.casePath, {otherView, "curves", "csv"}, ownCurves(owner)).string();
    if (const auto written = writeCenterline2d(core::allCurves(core::curvesOf(target)), path); !written) {
        return written.error();
    }
    auto hash = sha256OfFile(path);
    return hash ? core::Result<core::InputFile>(core::InputFile{path, std::move(hash).value()}) : hash.error();
}

core::InputFile exportedFile(const core::GivenTarget& target)
{
    if (!target.editedFrame || !target.centerline) {
        return target.file;
    }
    const auto hash = sha256OfText(centerline2dText(core::allCurves(core::curvesOf(target))));
    return {{}, hash ? hash.value() : std::string()};
}

}   // namespace angiopose::io
