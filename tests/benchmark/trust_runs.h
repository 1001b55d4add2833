#pragma once

#include "core/evaluation/report/result_table.h"
#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/asked_case.h"

namespace angiopose::benchmarks {

/// What a registration said of itself, and the truth.
struct TrustRun {
    std::string tree;
    std::string kind;
    bool isImpossible = false;
    double errorMm = 0.0;   ///< of the overlay
    core::RegistrationResult result;

    bool isWithin() const { return !isImpossible && errorMm < 2.0; }
};

/// Registers by the default method.
TrustRun runOf(const AskedCase& asked);

std::size_t treeCount(const std::vector<TrustRun>& runs);

/// By kind: how many errors below 2, of 2 to 5 and above 5 mm and how many impossible cases are flagged.
core::ResultTable flagTable(const std::vector<TrustRun>& runs);

/// By bins of the probability stated: how many overlays were within 2 mm.
core::ResultTable reliabilityTable(const std::vector<TrustRun>& runs);

/// Shares with their 95 % intervals by drawing trees anew; how good the probabilities are.
std::string summaryOf(const std::vector<TrustRun>& runs);

/// One line for each run: the signs that the probability is made from, and the error.
std::string csvOf(const std::vector<TrustRun>& runs);

}   // namespace angiopose::benchmarks
