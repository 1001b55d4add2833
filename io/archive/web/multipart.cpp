#include "io/archive/web/multipart.h"

#include "io/messages/messages.h"

#include <algorithm>
#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t maxHeaderBytes = std::size_t{16} << 10;
constexpr std::size_t maxBoundary = 70;
constexpr std::string_view lineEnd = "\r\n";

std::string toLower(std::string text)
{
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return text;
}

core::Error malformedResponse()
{
    return core::Error(messages::archiveNonsense("multipart"));
}

}   // namespace

std::optional<std::string> parseBoundary(const std::string& contentType)
{
    const std::string lower = toLower(contentType);
    const std::size_t at = lower.find("boundary=");
    if (!lower.starts_with("multipart/") || at == std::string::npos) {
        return std::nullopt;
    }
    std::string value = contentType.substr(at + std::string_view("boundary=").size());
    if (value.starts_with('"')) {
        value = value.substr(1, value.find('"', 1) - 1);
    } else {
        value = value.substr(0, value.find_first_of("; \t\r\n"));
    }
    return value.empty() || value.size() > maxBoundary ? std::nullopt : std::optional(value);
}

MultipartReader::MultipartReader(const std::string& boundary, Handler handler)
    : delimiter_("\r\n--" + boundary),
      handler_(std::move(handler)),
      buffer_(lineEnd)   // the initial line end makes a delimiter at the very start of the body match
{
}

core::Status MultipartReader::feed(std::string_view piece)
{
    if (state_ == State::Closed) {
        return core::Done{};   // ignore the epilogue
    }
    buffer_ += piece;
    for (;;) {
        auto moved = step();
        if (!moved) {
            return moved.error();
        }
        if (!moved.value()) {
            return core::Done{};
        }
    }
}

/// Processes the buffered bytes in the current state; returns true if the remaining bytes may need another step.
core::Result<bool> MultipartReader::step()
{
    switch (state_) {
        case State::Preamble:
            return findFirstBoundary();
        case State::AfterBoundary:
            return consumeBoundary();
        case State::Headers:
            return consumeHeaders();
        case State::Content:
            return consumeContent();
        case State::Closed:
            break;
    }
    return false;
}

core::Result<bool> MultipartReader::findFirstBoundary()
{
    const std::size_t at = buffer_.find(delimiter_);
    if (at == std::string::npos) {
        return buffer_.size() > maxHeaderBytes ? core::Result<bool>(malformedResponse()) : core::Result<bool>(false);
    }
    buffer_.erase(0, at + delimiter_.size());
    state_ = State::AfterBoundary;
    return true;
}

core::Result<bool> MultipartReader::consumeBoundary()
{
    if (buffer_.starts_with("--")) {
        state_ = State::Closed;
        buffer_.clear();
        return false;
    }
    const std::size_t end = buffer_.find(lineEnd);
    if (end == std::string::npos) {
        return buffer_.size() > maxHeaderBytes ? core::Result<bool>(malformedResponse()) : core::Result<bool>(false);
    }
    if (buffer_.find_first_not_of(" \t") != end) {
        return malformedResponse();
    }
    buffer_.erase(0, end);   // keep the line end: it starts the headers, which may be empty
    state_ = State::Headers;
    return true;
}

core::Result<bool> MultipartReader::consumeHeaders()
{
    const std::size_t end = buffer_.find("\r\n\r\n");
    if (end == std::string::npos) {
        return buffer_.size() > maxHeaderBytes ? core::Result<bool>(malformedResponse()) : core::Result<bool>(false);
    }
    if (end > maxHeaderBytes) {
        return malformedResponse();
    }
    buffer_.erase(0, end + 4);
    state_ = State::Content;
    if (auto begun = handler_.begin(); !begun) {
        return begun.error();
    }
    return true;
}

core::Result<bool> MultipartReader::consumeContent()
{
    const std::size_t at = buffer_.find(delimiter_);
    // If no delimiter was found, the last bytes may be the start of an incomplete one.
    const std::size_t content = at != std::string::npos               ? at
                                : buffer_.size() >= delimiter_.size() ? buffer_.size() - delimiter_.size() + 1
                                                                      : 0;
    if (content > 0) {
        if (auto taken = handler_.take(std::string_view(buffer_).substr(0, content)); !taken) {
            return taken.error();
        }
    }
    if (at == std::string::npos) {
        buffer_.erase(0, content);
        return false;
    }
    buffer_.erase(0, at + delimiter_.size());
    state_ = State::AfterBoundary;
    if (auto ended = handler_.end(); !ended) {
        return ended.error();
    }
    return true;
}

}   // namespace angiopose::io
