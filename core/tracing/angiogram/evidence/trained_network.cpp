#include "core/tracing/angiogram/evidence/vessel_network.h"

#ifdef ANGIOPOSE_VESSEL_NETWORK
// The weights lie in the program's read-only data: nothing is installed beside it, and nothing is read at its start.
asm(".pushsection .rodata\n"
    ".balign 16\n"
    ".local angioposeVesselNetwork\n"
    ".local angioposeVesselNetworkEnd\n"
    "angioposeVesselNetwork:\n"
    ".incbin \"" ANGIOPOSE_VESSEL_NETWORK
    "\"\n"
    "angioposeVesselNetworkEnd:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" {
extern const std::uint8_t angioposeVesselNetwork[] __attribute__((visibility("hidden")));
extern const std::uint8_t angioposeVesselNetworkEnd[] __attribute__((visibility("hidden")));
}
#endif

namespace angiopose::core {
namespace {

std::span<const std::uint8_t> builtInWeights()
{
#ifdef ANGIOPOSE_VESSEL_NETWORK
    return {angioposeVesselNetwork, angioposeVesselNetworkEnd};
#else
    return {};
#endif
}

}   // namespace

const VesselNetwork* trainedNetwork()
{
    static const std::optional<VesselNetwork> network =
        builtInWeights().empty() ? std::nullopt : VesselNetwork::read(builtInWeights());
    return network ? &*network : nullptr;
}

}   // namespace angiopose::core
