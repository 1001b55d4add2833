#pragma once

#include "core/support/result.h"
#include "core/support/verdict.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// How far an exchange with an archive is.
struct ArchiveProgress {
    std::size_t objects = 0;   ///< sent, come, or there already
    std::size_t all = 0;   ///< 0: not known
    std::uint64_t bytes = 0;
};

/// Called several times a second on the calling thread. Its Stop ends the exchange within about a second.
using ArchiveObserver = std::function<core::Verdict(const ArchiveProgress&)>;

/// What became of the objects of an exchange.
struct TransferReport {
    std::size_t all = 0;   ///< that were to be transferred; 0: not known
    std::size_t transferred = 0;
    std::size_t duplicates = 0;   ///< that were there already
    std::size_t failed = 0;
    std::uint64_t bytes = 0;   ///< of those transferred
    std::vector<std::string> folders;   ///< where what was retrieved lies, one per series
    core::Messages problems;   ///< of single objects, at most `mostProblems`
    std::optional<core::Error> end;   ///< why it ended early: an error or Stop

    static constexpr std::size_t mostProblems = 20;

    void note(const core::Message& problem)
    {
        if (problems.size() < mostProblems) {
            problems.push_back(problem);
        }
    }
    bool isWhole() const { return !end && failed == 0; }
};

/// "1.5 GB", for messages.
std::string sizeText(std::uint64_t bytes);

/// "0xA700".
std::string statusText(unsigned status);

}   // namespace angiopose::io
