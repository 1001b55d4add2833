#pragma once

#include "core/evaluation/report/result_table.h"
#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/asked_case.h"

namespace angiopose::benchmarks {

/// The self-assessment of a registration, and the truth.
struct TrustRun {
    std::string tree;
    std::string kind;
    bool isImpossible = false;
    double errorMm = 0.0;   ///< overlay error
    core::RegistrationResult result;

    bool isWithin() const { return !isImpossible && errorMm < 2.0; }
};

/// Registers by the default method.
TrustRun runOf(const RequestedCase& asked);

std::size_t treeCount(const std::vector<TrustRun>& runs);

/// By kind: number of flagged results with errors below 2, of 2 to 5 and above 5 mm, and number of flagged impossible
/// cases.
core::ResultTable flagTable(const std::vector<TrustRun>& runs);

/// By bins of the stated probability: number of overlays that were within 2 mm.
core::ResultTable reliabilityTable(const std::vector<TrustRun>& runs);

/// Shares with 95 % intervals from resampling the trees, and the quality of the probabilities.
std::string summaryOf(const std::vector<TrustRun>& runs);

/// One line per registration: the features from which the probability is computed, and the error.
std::string csvOf(const std::vector<TrustRun>& runs);

}   // namespace angiopose::benchmarks
