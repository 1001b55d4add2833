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
    std::string body;   ///< where no sink took it
};

/// Sends and receives over HTTP(S) on one kept connection: certificates checked, no redirects, no other protocol, every
/// wait bounded.
class HttpConnection {
public:
    using StopQuestion = std::function<bool()>;
    /// Takes a piece of a body whose status is 200; its failure ends the transfer.
    using Sink = std::function<core::Status(std::string_view piece, const std::string& contentType)>;
    /// Fills a buffer with the next bytes to send; how many: 0 at the end, nothing where they cannot be read.
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

/// A text as part of a query.
std::string urlEscaped(std::string_view text);

/// The address of a node without a last slash.
std::string webBase(const ArchiveNode& node);

/// The JSON that answers a query; empty where nothing matches. Fails, naming the service, on any other status.
core::Result<std::string> askWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                 const std::string& url);

}   // namespace angiopose::io
