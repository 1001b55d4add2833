#include "io/archive/dimse/network.h"

#include "io/archive/dimse/association_failure.h"
#include "io/messages/says_archive.h"
#include "io/support/quiet_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's macros first.
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dul.h>
#include <dcmtk/ofstd/ofsockad.h>
#include <dcmtk/ofstd/ofstd.h>
#include <chrono>
#include <future>
#include <memory>
#include <thread>

namespace angiopose::io {

void prepareNetwork(int answerSeconds)
{
    quietLibraries();
    OFStandard::initializeNetwork();
    dcmConnectionTimeout.set(connectSeconds);
    dcmSocketSendTimeout.set(answerSeconds);
    dcmSocketReceiveTimeout.set(answerSeconds);
    dcmDisableGethostbyaddr.set(OFTrue);
}

core::Status resolveHost(const ArchiveNode& node, const StopQuestion& isStopWished)
{
    // Without network it may take half a minute: it is left behind.
    auto promise = std::make_shared<std::promise<bool>>();
    auto isKnown = promise->get_future();
    std::thread([promise, host = node.host] {
        OFSockAddr address;
        OFStandard::getAddressByHostname(host.c_str(), address);
        promise->set_value(address.size() > 0);
    }).detach();
    for (int tenths = 0; tenths < 10 * connectSeconds; ++tenths) {
        if (isKnown.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready) {
            return isKnown.get() ? core::Status(core::Done{})
                                 : core::Error(says::archiveUnknownHost(node.host).about(node.name));
        }
        if (isStopWished()) {
            return stoppedAssociation(node);
        }
    }
    return core::Error(says::archiveUnknownHost(node.host).about(node.name));
}

}   // namespace angiopose::io
