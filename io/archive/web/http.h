#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

struct HttpReply {
    long status = 0;
    std::string contentType;
    std::string body;   ///< the body, unless a sink received it
};

/// Sends and receives over HTTP(S) on one persistent connection. Verifies certificates, follows no redirects, permits
/// no other protocol, and every wait has a timeout.
class HttpConnection {
public:
    using StopQuestion = std::function<bool()>;
    /// Receives a piece of the body of a response with status 200; an error ends the transfer.
    using Sink = std::function<core::Status(std::string_view piece, const std::string& contentType)>;
    /// Fills a buffer with the next bytes to send and returns their number: 0 at the end, nothing if they cannot be
    /// read.
    using Source = std::function<std::optional<std::size_t>(char* buffer, std::size_t size)>;

    static core::Result<HttpConnection> open(const ArchiveNode& node, StopQuestion isStopRequested);
    HttpConnection(HttpConnection&&) noexcept;
    HttpConnection& operator=(HttpConnection&&) = delete;
    ~HttpConnection();

    core::Result<HttpReply> get(const std::string& url, const std::string& accept, const Sink& sink = {});

    struct Upload {
        std::string contentType;
        std::string accept;
        std::uint64_t bytes = 0;
        Source source;
    };
    core::Result<HttpReply> post(const std::string& url, const Upload& upload);

private:
    struct Parts;
    explicit HttpConnection(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

/// Percent-encodes a text for a query.
std::string urlEscaped(std::string_view text);

/// Returns the address of a node without a trailing slash.
std::string webBase(const ArchiveNode& node);

/// Sends a query and returns the JSON of the response; empty if nothing matches. Fails, naming the service, on any
/// status that is not a success.
core::Result<std::string> askWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                 const std::string& url);

}   // namespace angiopose::io
