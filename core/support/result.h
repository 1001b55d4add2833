#pragma once

#include "core/support/message.h"

#include <utility>
#include <variant>

namespace angiopose::core {

/// Outcome of an operation that the user canceled; the message states what was left undone.
struct Cancellation {
    Message message;
};

/// Reason why there is no value: a message on which the user can act (file or value, problem, remedy), or cancellation.
class Error {
public:
    Error(const Message& problem) : message(problem.as(Severity::Error)) {}
    Error(const Cancellation& stopped) : message(stopped.message.as(Severity::Note)), isCancellation_(true) {}

    bool isCancellation() const { return isCancellation_; }

    /// Returns the same error with a file, or a key in a file, as its subject.
    Error about(std::string_view subject) const
    {
        Error reported = *this;
        reported.message = message.about(subject);
        return reported;
    }

    Message message;

private:
    bool isCancellation_ = false;
};

/// A value, or the reason why there is none: an error or a cancellation. Check before use.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}
    Result(const Cancellation& stopped) : content_(Error(stopped)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    bool isStopped() const { return !*this && error().isCancellation(); }
    const T& value() const& { return std::get<T>(content_); }
    T&& value() && { return std::get<T>(std::move(content_)); }
    const Error& error() const { return std::get<Error>(content_); }

private:
    std::variant<T, Error> content_;
};

/// Value type of operations that only succeed or fail.
struct Done {};
using Status = Result<Done>;

}   // namespace angiopose::core
