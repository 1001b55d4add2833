#pragma once

#include "angiopose/export.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace angiopose {

/// Something to tell the user: `id` is for programs and stays when words change, `text` is the English sentence.
struct Message {
    std::string id;   ///< "text.plain" where a sentence has none of its own
    std::string text;
    std::vector<std::string> arguments;   ///< what fills the sentence: names, numbers with their unit
};

/// Every function that cannot do its work throws this: `what()` says which file or value, the problem, the remedy.
class ANGIOPOSE_EXPORT Error : public std::runtime_error {
public:
    Error(std::string id, const std::string& sentence);
    ~Error() override;

    const std::string& id() const noexcept { return id_; }

private:
    std::string id_;
};

/// The observer stopped work that has nothing to give back: reading, tracing. A registration that is stopped returns
/// the best pose so far instead, with StopReason::StoppedByUser.
class ANGIOPOSE_EXPORT Stopped : public Error {
public:
    using Error::Error;
    ~Stopped() override;
};

}   // namespace angiopose
