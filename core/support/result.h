#pragma once

#include <string>
#include <utility>
#include <variant>

namespace angiopose::core {

/// What went wrong, in one sentence the user can act on: which file or value, the problem, the remedy.
struct Error {
    std::string message;
};

/// Either a value or the reason there is none. Check before use.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
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