#include "io/archive/dimse/take_object.h"

#include "io/archive/dimse/file_header.h"
#include "io/messages/says_archive.h"

namespace angiopose::io {
namespace {

std::uint16_t statusOf(Arrivals::Fate fate)
{
    switch (fate) {
        case Arrivals::Fate::Kept:
            return dimse::success;
        case Arrivals::Fate::Differs:
            return dimse::duplicateInstance;
        case Arrivals::Fate::Refused:
            break;
    }
    return dimse::cannotUnderstand;
}

}   // namespace

core::Status takeObject(DimseLink& link, const DimseLink::Received& request, const ExpectedObject& expected,
                        Arrivals& arrivals)
{
    const auto context = link.contextOf(request.context);
    if (!context || !request.command.hasData()) {
        return core::Error(says::archiveNonsense("C-STORE"));
    }
    ExpectedObject object = expected;
    object.sopInstance = request.command.text(DimseCommand::affectedInstance);
    auto begun = arrivals.begin();
    if (!begun) {
        return begun.error();
    }
    IncomingObject incoming = std::move(begun).value();
    const std::string header = encodedHeader(
        {request.command.text(DimseCommand::affectedClass), object.sopInstance, context->transferSyntax, {}});
    if (auto written = incoming.write(header); !written) {
        return written;
    }
    auto received =
        link.receivePieces([&arrivals, &incoming](std::string_view piece) { return arrivals.write(incoming, piece); });
    if (!received) {
        return received;
    }
    const auto fate = arrivals.take(std::move(incoming), object);
    if (!fate) {
        // The peer learns why before the association ends.
        (void)link.send(request.context, request.command.response(dimse::outOfResources));
        return fate.error();
    }
    return link.send(request.context, request.command.response(statusOf(fate.value())));
}

}   // namespace angiopose::io
