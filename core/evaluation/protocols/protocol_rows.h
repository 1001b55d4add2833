#pragma once

#include "core/evaluation/protocols/protocol.h"

namespace angiopose::core {

/// Random streams of an experiment, one per protocol. Random draws in one protocol never affect another protocol.
enum ProtocolNumber : std::uint64_t {
    toyNumber = 1,
    simulationNumber,
    robustnessNumber,
    clinicalNumber,
    captureRangeNumber,
    confidenceNumber
};

Protocol toyProtocol();
Protocol simulationProtocol();
Protocol robustnessProtocol();
Protocol clinicalProtocol();
Protocol captureRangeProtocol();
Protocol confidenceProtocol();
Protocol ownProtocol();   ///< protocol whose conditions come from the runs

template <class Setting>
std::vector<Condition> conditionsOf(const std::vector<Setting>& settings)
{
    std::vector<Condition> conditions;
    conditions.reserve(settings.size());
    for (const Setting& setting : settings) {
        conditions.push_back(setting.condition);
    }
    return conditions;
}

}   // namespace angiopose::core
