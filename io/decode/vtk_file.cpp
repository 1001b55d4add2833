#include "io/decode/vtk_file.h"

#include "io/decode/ask_decoder.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"

namespace angiopose::io {
namespace {

/// What VTK made of the file, or where it was found damaged; the words for that are the format's.
template <class SaysDamaged>
core::Result<VtkLines> readByVtk(const std::string& format, const std::string& path, const ReadObserver& observe,
                                 const SaysDamaged& saysDamaged)
{
    auto asked = askDecoder("angiopose-decode-vtk", {format, path}, path, observe);
    if (!asked) {
        return asked.error();
    }
    const DecoderReply reply = std::move(asked).value();
    if (reply.kind == ReplyKind::Refusal) {
        return fileError(path, saysDamaged(reply.content));
    }
    auto lines = linesFromReply(reply.content);
    return lines ? core::Result<VtkLines>(std::move(*lines)) : fileError(path, says::decoderDied());
}

}   // namespace

core::Result<VtkLines> readLegacyVtk(std::string_view content, const std::string& path, const ReadObserver& observe)
{
    TextCursor cursor(content);
    cursor.line();
    const std::string title = lowered(cursor.line());
    const std::string coding = lowered(cursor.word());
    if (coding != "ascii" && coding != "binary") {
        return fileError(path, says::vtkThirdLine());
    }
    const bool hasDataSet = lowered(cursor.word()) == "dataset";
    const std::string_view name = cursor.word();
    const std::string kind = lowered(name);
    if (!hasDataSet || (kind != "polydata" && kind != "unstructured_grid")) {
        return fileError(path,
                         kind.empty() ? says::vtkNoDataSet() : says::vtkOtherDataSet(std::string(name.substr(0, 40))));
    }
    auto lines = readByVtk(kind, path, observe, [](const std::string& section) {
        return says::vtkSectionDamaged(section.empty() ? "DATASET" : section);
    });
    if (!lines) {
        return lines;
    }
    VtkLines turned = std::move(lines).value();
    turned.set.isRas |= title.find("space=ras") != std::string::npos;   // Slicer notes it in the title
    return turned;
}

core::Result<VtkLines> readPly(const std::string& path, const ReadObserver& observe)
{
    auto lines = readByVtk("ply", path, observe, [](const std::string& place) {
        const std::string_view element = "element ";
        return place.starts_with(element) ? says::plyElementEmpty(place.substr(element.size(), 24))
               : place == "header"        ? says::plyHeaderDamaged()
                                          : says::plyDataDamaged();
    });
    const bool isDead = !lines && lines.error().message.is(says::decoderDied);   // of data that are not there, mostly
    return isDead ? fileError(path, says::plyDataDamaged()) : std::move(lines);
}

}   // namespace angiopose::io
