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

/// Called about once a second while waiting and for every fragment sent or received. Returns true to abort.
using StopCheck = std::function<bool()>;

/// Returns whether another association was active since the last call; such activity extends the timeout.
using ActivityCheck = std::function<bool()>;

/// Timeout for establishing a connection, s.
inline constexpr int connectTimeoutSeconds = 5;

/// Configures DCMTK's process-wide settings: disables logging and sets timeouts of at least `responseTimeoutSeconds`.
void configureDcmtkNetwork(int responseTimeoutSeconds);

/// Resolves the node's host name; fails if resolution takes longer than `connectTimeoutSeconds`.
core::Status resolveHost(const ArchiveNode& node, const StopCheck& isStopRequested);

/// Presentation context to propose: an abstract syntax (service or SOP class) with its transfer syntaxes.
struct ProposedContext {
    std::string abstractSyntax;
    std::vector<std::string> transferSyntaxes;
    bool isForReceiving = false;   ///< true if the archive sends these objects to us on this association (C-GET)
};

struct AcceptedContext {
    std::uint8_t id = 0;
    std::string abstractSyntax;
    std::string transferSyntax;
};

/// A presentation data value: one fragment of a message (PS3.8 9.3.5).
struct PresentationDataValue {
    enum class Kind { Command, DataSet };
    Kind kind = Kind::Command;
    std::uint8_t context = 0;
    std::string_view bytes;   ///< after a read, valid only until the next one
    bool isLast = false;
};

/// A DICOM association, implemented with DCMTK, that exchanges message fragments. Every wait has a timeout. The
/// destructor aborts the association unless it was released.
class Association {
public:
    static core::Result<std::unique_ptr<Association>> request(const ArchiveNode& node,
                                                              const std::vector<ProposedContext>& contexts,
                                                              StopCheck isStopRequested);
    /// Wraps an incoming association that is already acknowledged.
    Association(T_ASC_Association* accepted, const ArchiveNode& peer, StopCheck isStopRequested);

    Association(const Association&) = delete;
    Association& operator=(const Association&) = delete;
    ~Association();

    const ArchiveNode& node() const { return node_; }
    const std::vector<AcceptedContext>& contexts() const { return contexts_; }
    std::size_t maxFragmentBytes() const;   ///< maximum fragment size that the peer accepts, bytes
    bool isStopRequested() const { return isStopRequested_(); }

    core::Status write(const PresentationDataValue& value);
    /// Reads the next fragment. If the peer requests a release instead, confirms the release and returns nullopt.
    core::Result<std::optional<PresentationDataValue>> read(const ActivityCheck& hasActivity = {});

    /// Releases the association; nothing can be sent afterwards.
    void release();

private:
    Association(const ArchiveNode& node, StopCheck isStopRequested);
    core::Status connect(const std::vector<ProposedContext>& contexts);
    core::Status waitForData(const ActivityCheck& hasActivity) const;
    core::Error failure(const OFCondition& condition);

    ArchiveNode node_;
    StopCheck isStopRequested_;
    TransportLayer tls_;   // must outlive the network that uses it
    T_ASC_Network* network_ = nullptr;
    T_ASC_Association* association_ = nullptr;
    std::vector<AcceptedContext> contexts_;
    bool isClosed_ = false;   ///< true once nothing more may be sent to the peer
};

}   // namespace angiopose::io
