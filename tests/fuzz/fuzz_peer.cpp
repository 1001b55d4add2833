#include "io/archive/dimse/command.h"
#include "io/archive/dimse/identifier.h"
#include "io/archive/web/dicom_json.h"
#include "io/archive/web/multipart.h"
#include "tests/fuzz/input_file.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace angiopose;

namespace {

/// Parts of a multipart body that arrives in pieces of `pieceSize` bytes, and whether it ended correctly.
struct Parts {
    std::vector<std::string> contents;
    bool isLawful = true;
    bool isClosed = false;

    bool operator==(const Parts&) const = default;
};

Parts partsOf(const std::string& boundary, std::string_view body, std::size_t pieceSize)
{
    Parts parts;
    io::MultipartReader reader(boundary, {[&parts]() -> core::Status {
                                              parts.contents.emplace_back();
                                              return core::Done{};
                                          },
                                          [&parts](std::string_view piece) -> core::Status {
                                              parts.contents.back() += piece;
                                              return core::Done{};
                                          },
                                          []() -> core::Status { return core::Done{}; }});
    for (; parts.isLawful && !body.empty(); body.remove_prefix(std::min(pieceSize, body.size()))) {
        parts.isLawful = static_cast<bool>(reader.feed(body.substr(0, pieceSize)));
    }
    parts.isClosed = reader.isClosed();
    return parts;
}

void readCommand(std::string_view bytes)
{
    const auto command = io::DimseCommand::decode(bytes);
    if (!command) {
        return;
    }
    (void)io::statusText(*command);
    const auto again = io::DimseCommand::decode(command->encoded());
    if (!again || again->kind() != command->kind() || again->status() != command->status()) {
        std::abort();
    }
}

/// Reads the header line, then the body. The piece size makes no difference for a valid body (a part not found within a
/// few kilobytes is invalid only when read in pieces).
void readMultipart(std::string_view content)
{
    const std::size_t end = std::min(content.find('\n'), content.size());
    const auto boundary = io::parseBoundary(std::string(content.substr(0, end)));
    if (!boundary) {
        return;
    }
    const std::string_view body = content.substr(std::min(end + 1, content.size()));
    const Parts whole = partsOf(*boundary, body, body.size() + 1);
    const Parts pieces = partsOf(*boundary, body, 7);
    if (whole.isLawful && pieces.isLawful && !(whole == pieces)) {
        std::abort();
    }
}

}   // namespace

// Fuzzes everything an archive sends before it becomes a file: DIMSE commands and responses, JSON and DICOMweb bodies;
// the first byte selects the reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) {
        return 0;
    }
    const std::string_view content = fuzz::viewOf(data, size).substr(1);
    switch (data[0] % 4) {
        case 0:
            readCommand(content);
            break;
        case 1:
            (void)io::decodeIdentifier(content);
            break;
        case 2:
            (void)io::parseMatches(std::string(content));
            (void)io::parseObjects(std::string(content));
            (void)io::parseStoreResult(std::string(content));
            break;
        default:
            readMultipart(content);
            break;
    }
    return 0;
}
