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

struct HttpResponse {
    long status = 0;
    std::string contentType;
    std::string body;   ///< response body, unless a sink received it
};

/// Sends and receives over HTTP(S) on one persistent connection. Verifies certificates, follows no redirects, permits
/// no other protocol, and limits every wait by a timeout.
class HttpConnection {
public:
    using StopCheck = std::function<bool()>;
    /// Receives a chunk of the body of a response with status 200; an error cancels the transfer.
    using Sink = std::function<core::Status(std::string_view piece, const std::string& contentType)>;
    /// Fills a buffer with the next bytes to send and returns their number: 0 at the end, nullopt on a read error.
    using Source = std::function<std::optional<std::size_t>(char* buffer, std::size_t size)>;

    static core::Result<HttpConnection> open(const ArchiveNode& node, StopCheck isStopRequested);
    HttpConnection(HttpConnection&&) noexcept;
    HttpConnection& operator=(HttpConnection&&) = delete;
    ~HttpConnection();

    core::Result<HttpResponse> get(const std::string& url, const std::string& accept, const Sink& sink = {});

    struct Upload {
        std::string contentType;
        std::string accept;
        std::uint64_t bytes = 0;
        Source source;
    };
    core::Result<HttpResponse> post(const std::string& url, const Upload& upload);

private:
    struct Impl;
    explicit HttpConnection(std::unique_ptr<Impl> parts);

    std::unique_ptr<Impl> impl_;
};

/// Percent-encodes a string for a URL query.
std::string percentEncode(std::string_view text);

/// Returns the DICOMweb address of a node without a trailing slash.
std::string dicomWebUrl(const ArchiveNode& node);

/// Sends a query and returns the JSON of the response; empty if nothing matches. Fails and names the service if the
/// status is not success.
core::Result<std::string> queryDicomWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                        const std::string& url);

}   // namespace angiopose::io
