#include "io/vessel_tree_file.h"

#include "io/decode/vtk_file.h"
#include "io/messages/says.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/vessel/markups.h"
#include "io/vessel/swc.h"
#include "io/vessel/tree_table.h"
#include "io/vessel/vtk_lines.h"
#include "io/vessel/vtp_text.h"

#include <cmath>

namespace angiopose::io {
namespace {

core::Result<LineSet> parseVtk(std::string_view content, double unitMm, const std::string& path,
                               const ReadObserver& observe)
{
    auto lines = content.starts_with("# vtk DataFile") ? readLegacyVtk(content, path, observe)
                                                       : readXmlVtk(content, path, observe);
    if (!lines) {
        return lines.error();
    }
    LineSet set = lineSetOf(std::move(lines).value());
    for (Eigen::Vector3d& point : set.points) {
        point *= unitMm;
    }
    for (double& radius : set.radius) {
        radius *= unitMm;
    }
    return set;
}

/// By content where that decides, by extension for plain tables.
core::Result<LineSet> parseLines(std::string_view content, const std::string& path, double unitMm,
                                 const ReadObserver& observe)
{
    const bool isVtkXml = content.substr(0, 4096).find("<VTKFile") != std::string_view::npos;
    if (isVtkXml || content.starts_with("# vtk DataFile")) {
        return parseVtk(content, unitMm, path, observe);
    }
    const std::string extension = extensionOf(path);
    const auto* found = describeContent(content);
    if (found == &says::aJsonFile && extension == ".json") {
        return parseMarkups(content, path);
    }
    if (found != nullptr) {
        return fileError(path, says::treeIsOther((*found)()));
    }
    if (extension == ".swc") {
        return parseSwc(content, unitMm, path);
    }
    if (extension == ".csv" || extension == ".txt") {
        return parseTreeTable(content, unitMm, path);
    }
    if (extension == ".vtk" || extension == ".vtp" || extension == ".vtu") {
        return fileError(path, says::treeNoVtkBeginning());
    }
    return fileError(path, says::treeFormatUnknown());
}

}   // namespace

core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options,
                                              const ReadObserver& observe)
{
    if (!std::isfinite(options.unitMm) || options.unitMm <= 0.0) {
        return fileError(path, says::fileWrongUnit());
    }
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    auto lines = parseLines(input.value().view(), path, options.unitMm, observe);
    if (!lines) {
        return lines.error();
    }
    return treeFromLines(std::move(lines).value(), path);
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
    return fileError(path, says::treeExtension());
}

}   // namespace angiopose::io