#pragma once

#include "core/support/result.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the boundary of a content type "multipart/related; …; boundary=…"; nullopt if it is absent or invalid.
std::optional<std::string> parseBoundary(const std::string& contentType);

/// Parses a multipart body (RFC 2046 5.1) chunk by chunk and passes on the contents of the parts without storing them.
class MultipartReader {
public:
    struct Handler {
        std::function<core::Status()> begin;
        std::function<core::Status(std::string_view)> take;
        std::function<core::Status()> end;
    };

    MultipartReader(const std::string& boundary, Handler handler);

    /// Parses the next piece. Fails if the body is malformed, headers exceed 16 KiB, or the handler fails.
    core::Status feed(std::string_view piece);

    /// Returns whether the closing boundary was received; if not, the body is truncated.
    bool isClosed() const { return state_ == State::Closed; }

private:
    enum class State { Preamble, AfterBoundary, Headers, Content, Closed };

    core::Result<bool> step();
    core::Result<bool> findFirstBoundary();
    core::Result<bool> consumeBoundary();
    core::Result<bool> consumeHeaders();
    core::Result<bool> consumeContent();

    std::string delimiter_;   ///< the sequence "\r\n--boundary"
    Handler handler_;
    State state_ = State::Preamble;
    std::string buffer_;   ///< bytes received but not yet passed on
};

}   // namespace angiopose::io
