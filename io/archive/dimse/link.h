#pragma once

#include "core/support/result.h"
#include "io/archive/dimse/association.h"
#include "io/archive/dimse/command.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Messages to and fro over an association, which is aborted when this goes, unless it was released.
class DimseLink {
public:
    static core::Result<DimseLink> open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopQuestion isStopRequested);
    /// One that a peer asked for and that is acknowledged already.
    static DimseLink accepted(T_ASC_Association* association, const ArchiveNode& peer, StopQuestion isStopRequested);

    /// The context of a service, or for objects of that encoding; nothing where the archive did not take it.
    std::optional<AcceptedContext> contextFor(const std::string& abstractSyntax,
                                              const std::string& transferSyntax = {}) const;
    std::optional<AcceptedContext> contextOf(std::uint8_t id) const;

    core::Status send(std::uint8_t context, const DimseCommand& command);
    core::Status sendData(std::uint8_t context, std::string_view data);

    /// Gives the next piece of a data set and whether it is the last one.
    struct Piece {
        std::string_view bytes;
        bool isLast = false;
    };
    using PieceSource = std::function<core::Result<Piece>(std::size_t maxBytes)>;
    core::Status sendPieces(std::uint8_t context, const PieceSource& next);

    struct Received {
        DimseCommand command;
        std::uint8_t context = 0;
    };
    /// The next command. Nothing where the peer wants to release the association instead, which is granted.
    core::Result<std::optional<Received>> receive(const LifeQuestion& isAlive = {});

    using PieceSink = std::function<core::Status(std::string_view)>;
    core::Status receivePieces(const PieceSink& take);
    core::Result<std::string> receiveData();   ///< of an answer: small

    /// Ends it in order; afterwards nothing can be sent.
    void release();

private:
    explicit DimseLink(std::unique_ptr<Association> association);

    std::unique_ptr<Association> association_;
};

}   // namespace angiopose::io
