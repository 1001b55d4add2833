#pragma once

#include "angiopose/export.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace angiopose {

/// Message for the user: `id` is stable and intended for programs; `text` is the English sentence.
struct Message {
    std::string id;   ///< "text.plain" for sentences without an ID of their own
    std::string text;
    std::vector<std::string> arguments;   ///< values inserted into the sentence: names, and numbers with units
};

/// Thrown by every function that fails. `what()` names the file or value, the problem and the remedy.
class ANGIOPOSE_EXPORT Error : public std::runtime_error {
public:
    Error(std::string id, const std::string& sentence);
    ~Error() override;

    const std::string& id() const noexcept { return id_; }

private:
    std::string id_;
};

/// Thrown when the observer stops work that has no partial result (reading, tracing). A canceled registration instead
/// returns the best pose so far with StopReason::StoppedByUser.
class ANGIOPOSE_EXPORT Stopped : public Error {
public:
    using Error::Error;
    ~Stopped() override;
};

}   // namespace angiopose
