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

/// Exchanges DIMSE messages over an association. The destructor aborts the association unless it was released.
class DimseLink {
public:
    static core::Result<DimseLink> open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopQuestion isStopRequested);
    /// Wraps an association that a peer requested and that is already acknowledged.
    static DimseLink accepted(T_ASC_Association* association, const ArchiveNode& peer, StopQuestion isStopRequested);

    /// Returns the accepted presentation context of a service or object encoding; nothing if the archive rejected it.
    std::optional<AcceptedContext> contextFor(const std::string& abstractSyntax,
                                              const std::string& transferSyntax = {}) const;
    std::optional<AcceptedContext> contextOf(std::uint8_t id) const;

    core::Status send(std::uint8_t context, const DimseCommand& command);
    core::Status sendData(std::uint8_t context, std::string_view data);

    /// A fragment of a data set, and whether it is the last one.
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
    /// Receives the next command. Returns nothing if the peer requested a release instead, which is then confirmed.
    core::Result<std::optional<Received>> receive(const LifeQuestion& isAlive = {});

    using PieceSink = std::function<core::Status(std::string_view)>;
    core::Status receivePieces(const PieceSink& take);
    core::Result<std::string> receiveData();   ///< the whole data set of a response, which is small

    /// Releases the association; nothing can be sent afterwards.
    void release();

private:
    explicit DimseLink(std::unique_ptr<Association> association);

    std::unique_ptr<Association> association_;
};

}   // namespace angiopose::io
