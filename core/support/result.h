#pragma once

#include "core/support/message.h"

#include <utility>
#include <variant>

namespace angiopose::core {

/// The user asked for an end before the work was done: an outcome, nothing to fix. Says what was left.
struct Stopped {
    Message message;
};

/// Why there is no value: what went wrong, in a message the user can act on (which file or value, the problem, the
/// remedy), or that the user stopped it.
class Error {
public:
    Error(const Message& problem) : message(problem.as(Severity::Error)) {}
    Error(const Stopped& stopped) : message(stopped.message.as(Severity::Note)), isStop_(true) {}

    bool isStop() const { return isStop_; }

    /// The same, told of a file or of a key in one.
    Error about(std::string_view subject) const
    {
        Error reported = *this;
        reported.message = message.about(subject);
        return reported;
    }

    Message message;

private:
    bool isStop_ = false;
};

/// A value, or why there is none: an error or Stop. Check before use.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}
    Result(const Stopped& stopped) : content_(Error(stopped)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    bool isStopped() const { return !*this && error().isStop(); }
    const T& value() const& { return std::get<T>(content_); }
    T&& value() && { return std::get<T>(std::move(content_)); }
    const Error& error() const { return std::get<Error>(content_); }

private:
    std::variant<T, Error> content_;
};

/// The value of an operation that only succeeds or fails.
struct Done {};
using Status = Result<Done>;

}   // namespace angiopose::core
