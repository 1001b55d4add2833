#include "io/archive/dimse/receive_object.h"

#include "io/messages/messages.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace angiopose::io {
namespace {

/// File header to write before the data set of an object (PS3.10 7.1).
struct FileHeader {
    std::string sopClass;
    std::string sopInstance;
    std::string transferSyntax;
    std::string sourceTitle;   ///< AE title of the sender
};

constexpr const char* implementationClass = "2.25.277613902894205893846702311409541530624";
constexpr const char* implementationVersion = "ANGIOPOSE";

void appendLittle(std::string& bytes, std::size_t value, int size)
{
    for (int i = 0; i < size; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

/// Appends an element of group 0002 as explicit VR little endian.
void appendMeta(std::string& bytes, std::uint16_t element, std::string_view vr, std::string value, char padding = '\0')
{
    if (value.size() % 2 != 0) {
        value += padding;
    }
    appendLittle(bytes, 0x0002, 2);
    appendLittle(bytes, element, 2);
    bytes += vr;
    if (vr == "OB") {
        appendLittle(bytes, 0, 2);
        appendLittle(bytes, value.size(), 4);
    } else {
        appendLittle(bytes, value.size(), 2);
    }
    bytes += value;
}

std::string encodedHeader(const FileHeader& header)
{
    std::string meta;
    appendMeta(meta, 0x0001, "OB", std::string("\0\1", 2));
    appendMeta(meta, 0x0002, "UI", header.sopClass);
    appendMeta(meta, 0x0003, "UI", header.sopInstance);
    appendMeta(meta, 0x0010, "UI", header.transferSyntax);
    appendMeta(meta, 0x0012, "UI", implementationClass);
    appendMeta(meta, 0x0013, "SH", implementationVersion, ' ');
    if (!header.sourceTitle.empty()) {
        appendMeta(meta, 0x0016, "AE", header.sourceTitle, ' ');
    }
    std::string length, bytes(128, '\0');
    appendLittle(length, meta.size(), 4);
    bytes += "DICM";
    appendMeta(bytes, 0x0000, "UL", length);
    return bytes + meta;
}

std::uint16_t statusOf(StoreWriter::StoreOutcome fate)
{
    switch (fate) {
        case StoreWriter::StoreOutcome::Kept:
            return dimse::success;
        case StoreWriter::StoreOutcome::Differs:
            return dimse::duplicateInstance;
        case StoreWriter::StoreOutcome::Refused:
            break;
    }
    return dimse::cannotUnderstand;
}

}   // namespace

core::Status receiveObject(DimseLink& link, const DimseLink::ReceivedCommand& request, const ExpectedObject& expected,
                           StoreWriter& storeWriter)
{
    const auto context = link.contextWithId(request.context);
    if (!context || !request.command.hasData()) {
        return core::Error(messages::archiveNonsense("C-STORE"));
    }
    ExpectedObject object = expected;
    object.sopInstance = request.command.text(DimseCommand::affectedSopInstance);
    auto begun = storeWriter.begin();
    if (!begun) {
        return begun.error();
    }
    IncomingObject incoming = std::move(begun).value();
    const std::string header = encodedHeader(
        {request.command.text(DimseCommand::affectedSopClass), object.sopInstance, context->transferSyntax, {}});
    if (auto written = incoming.write(header); !written) {
        return written;
    }
    auto received = link.receiveFragments(
        [&storeWriter, &incoming](std::string_view piece) { return storeWriter.write(incoming, piece); });
    if (!received) {
        return received;
    }
    const auto fate = storeWriter.take(std::move(incoming), object);
    if (!fate) {
        // Report the failure to the peer before the association ends.
        (void)link.send(request.context, request.command.response(dimse::outOfResources));
        return fate.error();
    }
    return link.send(request.context, request.command.response(statusOf(fate.value())));
}

}   // namespace angiopose::io
