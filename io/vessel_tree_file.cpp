#include "io/vessel_tree_file.h"

#include "io/decode/vtk_file.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/vessel/markups.h"
#include "io/vessel/stated_coordinates.h"
#include "io/vessel/swc.h"
#include "io/vessel/tree_table.h"
#include "io/vessel/vtk_lines.h"
#include "io/vessel/vtp_text.h"

#include <algorithm>

namespace angiopose::io {
namespace {

/// Parses lines according to the content or, for plain tables, according to the extension; adds the descriptive text of
/// the file to `header`.
core::Result<LineSet> parseLines(std::string_view content, const std::string& path, std::string& header,
                                 const ReadObserver& observe)
{
    const bool isLegacyVtk = content.starts_with("# vtk DataFile");
    if (isLegacyVtk || content.substr(0, 4096).find("<VTKFile") != std::string_view::npos) {
        auto lines = isLegacyVtk ? readLegacyVtk(content, path, observe) : readXmlVtk(content, path, observe);
        if (!lines) {
            return lines.error();
        }
        header += lines.value().header;
        return lineSetOf(std::move(lines).value());
    }
    const std::string extension = extensionOf(path);
    const auto* found = describeContent(content);
    if (found == &messages::aJsonFile && extension == ".json") {
        return parseMarkups(content, path);
    }
    if (found != nullptr) {
        return fileError(path, messages::treeIsOther((*found)()));
    }
    if (extension == ".swc") {
        return parseSwc(content, path);
    }
    if (extension == ".csv" || extension == ".txt") {
        return parseTreeTable(content, path);
    }
    if (extension == ".vtk" || extension == ".vtp" || extension == ".vtu") {
        return fileError(path, messages::treeNoVtkBeginning());
    }
    return fileError(path, messages::treeFormatUnknown());
}

}   // namespace

core::Result<LoadedTree> readTree(const std::string& path, const VesselTreeReadOptions& options,
                                  const ReadObserver& observe)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    std::string header = headerText(input.value().view());
    auto lines = parseLines(input.value().view(), path, header, observe);
    // Slicer curves state their unit and are already converted to mm.
    const auto rule = coordinateConversion(header, extensionOf(path) == ".json" ? 1.0 : options.unitMm, path);
    if (!lines || !rule) {
        return lines ? rule.error() : lines.error();
    }
    LineSet set = std::move(lines).value();
    std::ranges::transform(set.points, set.points.begin(), rule.value());
    for (double& radius : set.radius) {
        radius *= rule.value().unitMm;
    }
    set.warnings.insert(set.warnings.begin(), rule.value().notes.begin(), rule.value().notes.end());
    auto tree = treeFromLines(std::move(set), path);
    if (!tree) {
        return tree;
    }
    LoadedTree read = std::move(tree).value();
    read.isUnitStated = rule.value().isUnitStated;
    return read;
}

core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options,
                                              const ReadObserver& observe)
{
    auto read = readTree(path, options, observe);
    return read ? core::Result<core::VesselTree>(std::move(read).value().tree) : read.error();
}

core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".csv") {
        return writeAtomically(path, treeTable(tree));
    }
    if (extension == ".vtp") {
        return writeAtomically(path, vtpText(tree));
    }
    if (extension == ".swc") {
        return writeAtomically(path, swcText(tree));
    }
    if (path.ends_with(".mrk.json")) {
        return writeAtomically(path, markupsText(tree));
    }
    return fileError(path, messages::treeExtension());
}

}   // namespace angiopose::io
