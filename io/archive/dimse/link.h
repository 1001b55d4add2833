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
                                        StopCheck isStopRequested);
    /// Wraps an incoming association that is already acknowledged.
    static DimseLink accepted(T_ASC_Association* association, const ArchiveNode& peer, StopCheck isStopRequested);

    /// Returns the accepted presentation context for a service or SOP class; nullopt if the archive rejected it.
    std::optional<AcceptedContext> contextFor(const std::string& abstractSyntax,
                                              const std::string& transferSyntax = {}) const;
    std::optional<AcceptedContext> contextWithId(std::uint8_t id) const;

    core::Status send(std::uint8_t context, const DimseCommand& command);
    core::Status sendData(std::uint8_t context, std::string_view data);

    /// Fragment of a data set, flagged if it is the last one.
    struct Fragment {
        std::string_view bytes;
        bool isLast = false;
    };
    using FragmentSource = std::function<core::Result<Fragment>(std::size_t maxBytes)>;
    core::Status sendFragments(std::uint8_t context, const FragmentSource& next);

    struct ReceivedCommand {
        DimseCommand command;
        std::uint8_t context = 0;
    };
    /// Receives the next command. If the peer requests a release instead, confirms the release and returns nullopt.
    core::Result<std::optional<ReceivedCommand>> receive(const ActivityCheck& hasActivity = {});

    using FragmentSink = std::function<core::Status(std::string_view)>;
    core::Status receiveFragments(const FragmentSink& take);
    core::Result<std::string> receiveData();   ///< receives the complete data set of a response, if it is small

    /// Releases the association; nothing can be sent afterwards.
    void release();

private:
    explicit DimseLink(std::unique_ptr<Association> association);

    std::unique_ptr<Association> association_;
};

}   // namespace angiopose::io
