#pragma once

#include "core/support/result.h"
#include "io/archive/dimse/command.h"
#include "io/archive/model/node.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct T_ASC_Association;

namespace angiopose::io {

/// A service or kind of object that is wanted on an association, in any of these encodings.
struct ProposedContext {
    std::string abstractSyntax;
    std::vector<std::string> transferSyntaxes;
    bool isForReceiving = false;   ///< the archive sends them to us on this association (C-GET)
};

struct AcceptedContext {
    std::uint8_t id = 0;
    std::string abstractSyntax;
    std::string transferSyntax;
};

/// Asked about once a second while nothing comes, and for every piece that goes or comes: true to end it.
using StopQuestion = std::function<bool()>;

/// Whether there was a sign of life elsewhere since last asked, which allows more time.
using LifeQuestion = std::function<bool()>;

/// An association: messages to and fro. Every wait is bounded. Aborted when it goes, unless it was released.
class DimseLink {
public:
    static core::Result<DimseLink> open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopQuestion isStopWished);
    /// One that a peer asked for and that is acknowledged already.
    static DimseLink accepted(T_ASC_Association* association, const ArchiveNode& peer, StopQuestion isStopWished);

    DimseLink(DimseLink&& other) noexcept;
    DimseLink& operator=(DimseLink&&) = delete;
    ~DimseLink();

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
    using PieceSource = std::function<core::Result<Piece>(std::size_t mostBytes)>;
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
    struct Parts;
    explicit DimseLink(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

/// How long until a connection must be there.
inline constexpr int connectSeconds = 5;

/// Sets what DCMTK keeps for the whole process: silence, and bounds of its waits. `answerSeconds` at least.
void prepareNetwork(int answerSeconds);

}   // namespace angiopose::io
