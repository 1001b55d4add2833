#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/faulty_peers.h"
#include "tests/io/archive/orthanc.h"

#include "io/messages/messages.h"

namespace angiopose::test {
namespace {

using io::ArchiveProtocol;

io::ArchiveNode nodeAt(int port)
{
    io::ArchiveNode node;
    node.name = "pacs";
    node.host = "127.0.0.1";
    node.port = port;
    node.webUrl = "https://127.0.0.1:" + std::to_string(port) + "/dicom-web";
    return node;
}

TEST(UnreachableArchive, ClosedPortIsSaidAtOnce)
{
    const int port = freePort();
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const Stopwatch watch;
        const auto echoed = io::echoArchive(nodeAt(port), way);
        ASSERT_FALSE(echoed);
        expectFailure(echoed.error(), io::messages::archiveNoConnection, watch);
        EXPECT_LT(watch.seconds(), 2.0);
    }
}

TEST(UnreachableArchive, SwallowedPacketsEndAfterFiveSeconds)
{
    const SwallowingPeer peer;
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const Stopwatch watch;
        const auto echoed = io::echoArchive(nodeAt(peer.port()), way);
        ASSERT_FALSE(echoed);
        expectFailure(echoed.error(), io::messages::archiveNoConnection, watch);
        EXPECT_LT(watch.seconds(), 7.0);
    }
}

TEST(UnreachableArchive, SilentPeerIsGivenUp)
{
    const SilentPeer peer;
    const Stopwatch watch;
    const auto echoed = io::echoArchive(nodeAt(peer.port()), ArchiveProtocol::Dimse);
    ASSERT_FALSE(echoed);
    expectFailure(echoed.error(), io::messages::archiveSilent, watch);
}

TEST(UnreachableArchive, SilentPeerIsGivenUpWithTls)
{
    const SilentPeer peer;
    io::ArchiveNode node = nodeAt(peer.port());
    node.responseTimeoutSeconds = 2;
    node.isTls = true;
    const Stopwatch watch;
    const auto dimse = io::echoArchive(node, ArchiveProtocol::Dimse);
    EXPECT_FALSE(dimse);
    const auto web = io::echoArchive(node, ArchiveProtocol::Web);
    EXPECT_FALSE(web);
    EXPECT_LT(watch.seconds(), 10.0);
}

TEST(UnreachableArchive, UnknownHostIsSaid)
{
    io::ArchiveNode node = nodeAt(104);
    node.host = "no-such-host.invalid";
    const Stopwatch watch;
    const auto echoed = io::echoArchive(node, ArchiveProtocol::Dimse);
    ASSERT_FALSE(echoed);
    expectFailure(echoed.error(), io::messages::archiveUnknownHost, watch);
}

}   // namespace
}   // namespace angiopose::test
