#include "io/decode/vtk_file.h"

#include "io/decode/ask_decoder.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"

#include <array>
#include <optional>

namespace angiopose::io {
namespace {

/// Reads a file through VTK; `saysDamaged` creates the error message for a damaged file of the format.
template <class SaysDamaged>
core::Result<VtkLines> readByVtk(const std::string& format, const std::string& path, const ReadObserver& observe,
                                 const SaysDamaged& saysDamaged)
{
    auto asked = runDecoder("angiopose-decode-vtk", {format, path}, path, observe);
    if (!asked) {
        return asked.error();
    }
    const DecoderReply reply = std::move(asked).value();
    if (reply.kind == ReplyKind::Refusal) {
        return fileError(path, saysDamaged(reply.content));
    }
    auto lines = linesFromReply(reply.content);
    return lines ? core::Result<VtkLines>(std::move(*lines)) : fileError(path, messages::decoderDied());
}

constexpr int maxDeclared = 20'000'000;

/// Rejects counts that no centerline can have, because VTK allocates what the header declares before reading the data.
std::optional<core::Message> findImpossibleCount(std::string_view content)
{
    constexpr std::array attributes = {"NumberOfPoints=\"", "NumberOfLines=\"",     "NumberOfVerts=\"",
                                       "NumberOfStrips=\"", "NumberOfPolys=\"",     "NumberOfCells=\"",
                                       "NumberOfTuples=\"", "NumberOfComponents=\""};
    for (const std::string_view attribute : attributes) {
        for (std::size_t at = content.find(attribute); at != std::string_view::npos;) {
            at += attribute.size();
            const std::string_view text = content.substr(at, content.substr(at, 64).find('"'));
            const auto value = parseInteger(text);
            const int limit = attribute.starts_with("NumberOfComponents") ? 1000 : maxDeclared;
            if (!value || *value < 0 || *value > limit) {
                return messages::vtkXmlImpossibleCount(std::string(attribute) + std::string(text.substr(0, 40)) + "\"");
            }
            at = content.find(attribute, at);
        }
    }
    return {};
}

}   // namespace

core::Result<VtkLines> readLegacyVtk(std::string_view content, const std::string& path, const ReadObserver& observe)
{
    TextReader cursor(content);
    cursor.line();
    cursor.line();   // skip the title
    const std::string coding = toLower(cursor.word());
    if (coding != "ascii" && coding != "binary") {
        return fileError(path, messages::vtkThirdLine());
    }
    const bool hasDataSet = toLower(cursor.word()) == "dataset";
    const std::string_view name = cursor.word();
    const std::string kind = toLower(name);
    if (!hasDataSet || (kind != "polydata" && kind != "unstructured_grid")) {
        return fileError(
            path, kind.empty() ? messages::vtkNoDataSet() : messages::vtkOtherDataSet(std::string(name.substr(0, 40))));
    }
    return readByVtk(kind, path, observe, [](const std::string& section) {
        return messages::vtkSectionDamaged(section.empty() ? "DATASET" : section);
    });
}

core::Result<VtkLines> readXmlVtk(std::string_view content, const std::string& path, const ReadObserver& observe)
{
    if (const auto impossible = findImpossibleCount(content)) {
        return fileError(path, *impossible);
    }
    const std::string_view head = content.substr(0, 4096);
    const bool isGrid = head.find("type=\"UnstructuredGrid\"") != std::string_view::npos;
    if (!isGrid && head.find("type=\"PolyData\"") == std::string_view::npos) {
        return fileError(path, messages::vtkXmlOther());
    }
    auto lines = readByVtk(isGrid ? "xml_unstructured_grid" : "xml_polydata", path, observe,
                           [](const std::string&) { return messages::vtkXmlDamaged(); });
    const bool isDead = !lines && lines.error().message.is(messages::decoderDied);   // hence the file is damaged
    return isDead ? fileError(path, messages::vtkXmlDamaged()) : std::move(lines);
}

core::Result<VtkLines> readPly(const std::string& path, const ReadObserver& observe)
{
    auto lines = readByVtk("ply", path, observe, [](const std::string& place) {
        const std::string_view element = "element ";
        return place.starts_with(element) ? messages::plyElementEmpty(place.substr(element.size(), 24))
               : place == "header"        ? messages::plyHeaderDamaged()
                                          : messages::plyDataDamaged();
    });
    const bool isDead =
        !lines && lines.error().message.is(messages::decoderDied);   // usually because declared data are missing
    return isDead ? fileError(path, messages::plyDataDamaged()) : std::move(lines);
}

}   // namespace angiopose::io
