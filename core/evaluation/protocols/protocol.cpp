#include "core/evaluation/protocols/protocol.h"

#include "core/evaluation/protocols/protocol_rows.h"
#include "core/messages/messages.h"

#include <algorithm>
#include <sstream>

namespace angiopose::core {

std::span<const Protocol> protocols()
{
    static const std::vector<Protocol> rows{toyProtocol(),      simulationProtocol(),   robustnessProtocol(),
                                            clinicalProtocol(), captureRangeProtocol(), confidenceProtocol()};
    return rows;
}

const Protocol* findProtocol(std::string_view id)
{
    static const Protocol own = ownProtocol();
    if (id == own.id) {
        return &own;
    }
    const auto all = protocols();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Protocol& row) { return row.id == id; });
    return found == all.end() ? nullptr : &*found;
}

Result<std::vector<std::size_t>> parseConditions(const Protocol& protocol, const std::string& requests)
{
    std::vector<bool> isChosen(protocol.conditions.size(), false);
    std::istringstream stream(requests);
    for (std::string request; std::getline(stream, request, ',');) {
        bool isKnown = false;
        for (std::size_t k = 0; k < protocol.conditions.size(); ++k) {
            const std::string& id = protocol.conditions[k].id;
            if (request == "all" || id == request || id.starts_with(request + "-")) {
                isChosen[k] = true;
                isKnown = true;
            }
        }
        if (!isKnown) {
            return Error(messages::noSuchCondition(protocol.id, request));
        }
    }
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < protocol.conditions.size(); ++k) {
        if (requests.empty() ? protocol.conditions[k].isStandard : isChosen[k]) {
            chosen.push_back(k);
        }
    }
    return chosen;
}

}   // namespace angiopose::core
