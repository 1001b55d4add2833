#pragma once

#include "core/support/result.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The boundary that a content type "multipart/related; …; boundary=…" names; nothing where it is none, or not a lawful
/// one.
std::optional<std::string> boundaryOf(const std::string& contentType);

/// Takes a body of several parts (RFC 2046 5.1) piece by piece and passes their contents on without keeping them.
class MultipartReader {
public:
    struct Handler {
        std::function<core::Status()> begin;
        std::function<core::Status(std::string_view)> take;
        std::function<core::Status()> end;
    };

    MultipartReader(const std::string& boundary, Handler handler);

    /// Fails where the body is not lawful, headers are longer than 16 KiB, and as the handler does.
    core::Status feed(std::string_view piece);

    /// Whether the closing boundary came: else the body was cut off.
    bool isClosed() const { return state_ == State::Closed; }

private:
    enum class State { Preamble, AfterBoundary, Headers, Content, Closed };

    core::Result<bool> step();
    core::Result<bool> findFirst();
    core::Result<bool> passBoundary();
    core::Result<bool> passHeaders();
    core::Result<bool> passContent();

    std::string delimiter_;   ///< "\r\n--boundary"
    Handler handler_;
    State state_ = State::Preamble;
    std::string left_;   ///< what came and is not passed on yet
};

}   // namespace angiopose::io
