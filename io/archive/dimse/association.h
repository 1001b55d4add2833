#pragma once

#include "core/support/result.h"
#include "io/archive/dimse/tls.h"
#include "io/archive/model/node.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class OFCondition;
struct T_ASC_Association;
struct T_ASC_Network;

namespace angiopose::io {

/// Asked about once a second while nothing comes, and for every piece that goes or comes: true to end it.
using StopQuestion = std::function<bool()>;

/// Whether there was a sign of life elsewhere since last asked, which allows more time.
using LifeQuestion = std::function<bool()>;

/// How long until a connection must be there.
inline constexpr int connectSeconds = 5;

/// Sets what DCMTK keeps for the whole process: silence, and bounds of its waits. `answerSeconds` at least.
void prepareNetwork(int answerSeconds);

/// Fails for a host that no resolver knows within `connectSeconds`.
core::Status resolveHost(const ArchiveNode& node, const StopQuestion& isStopRequested);

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

/// A piece of a message as it travels: a presentation data value (PS3.8 9.3.5).
struct DataValue {
    enum class Kind { Command, DataSet };
    Kind kind = Kind::Command;
    std::uint8_t context = 0;
    std::string_view bytes;   ///< what was read is valid until the next read
    bool isLast = false;
};

/// An association by DCMTK: pieces of messages to and fro. Every wait is bounded. Aborted when it goes, unless it was
/// released.
class Association {
public:
    /// Asks the node for one.
    static core::Result<std::unique_ptr<Association>> request(const ArchiveNode& node,
                                                              const std::vector<ProposedContext>& contexts,
                                                              StopQuestion isStopRequested);
    /// One that a peer asked for and that is acknowledged already.
    Association(T_ASC_Association* accepted, const ArchiveNode& peer, StopQuestion isStopRequested);

    Association(const Association&) = delete;
    Association& operator=(const Association&) = delete;
    ~Association();

    const ArchiveNode& node() const { return node_; }
    const std::vector<AcceptedContext>& contexts() const { return contexts_; }
    std::size_t maxPieceBytes() const;   ///< that the peer takes at once
    bool isStopRequested() const { return isStopRequested_(); }

    core::Status write(const DataValue& value);
    /// The next piece. Nothing where the peer wants to release the association instead, which is granted.
    core::Result<std::optional<DataValue>> read(const LifeQuestion& isAlive = {});

    /// Ends it in order; afterwards nothing can be sent.
    void release();

private:
    Association(const ArchiveNode& node, StopQuestion isStopRequested);
    core::Status connect(const std::vector<ProposedContext>& contexts);
    core::Status waitForData(const LifeQuestion& isAlive) const;
    core::Error failure(const OFCondition& condition);

    ArchiveNode node_;
    StopQuestion isStopRequested_;
    TransportLayer tls_;   // outlives the network that uses it
    T_ASC_Network* network_ = nullptr;
    T_ASC_Association* association_ = nullptr;
    std::vector<AcceptedContext> contexts_;
    bool isOver_ = false;   ///< nothing is to be told to the peer any more
};

}   // namespace angiopose::io
