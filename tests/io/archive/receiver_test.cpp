#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/faulty_peers.h"
#include "tests/io/archive/orthanc.h"

#include "io/archive/dimse/storage_scp.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace angiopose::test {
namespace {

using io::ArchiveProtocol;
using namespace std::string_literals;

/// A receiving port that runs during the test and stores into its own folder.
class ServedPort {
public:
    explicit ServedPort(io::StorageScpOptions options, const io::StoreLimit& limit = {},
                        std::uint64_t maxObject = 1u << 30)
        : store_(openStore(folder_.file("received"), maxObject)), arrivals_(store_, limit, report_, observe_)
    {
        arrivals_.setProblemCallback([this](const core::Message& problem) {
            const std::lock_guard lock(hearing_);
            heard_.push_back(problem);
        });
        options.port = freePort();
        port_ = options.port;
        auto listening = io::StorageScp::listen(options);
        EXPECT_TRUE(listening) << listening.error().message.text();
        receiver_.emplace(std::move(listening).value());
        thread_ = std::thread([this] { receiver_->serve(arrivals_, [this] { return isOver_.load(); }); });
    }
    ServedPort(const ServedPort&) = delete;
    ServedPort& operator=(const ServedPort&) = delete;
    ~ServedPort() { finish(); }

    void finish()
    {
        isOver_ = true;
        if (thread_.joinable()) {
            thread_.join();
        }
    }

    io::ArchiveNode node() const
    {
        io::ArchiveNode node;
        node.name = "here";
        node.host = "127.0.0.1";
        node.port = port_;
        node.title = "ANGIOPOSE";
        return node;
    }

    core::Messages heard() const   ///< messages so far
    {
        const std::lock_guard lock(hearing_);
        return heard_;
    }
    const io::TransferReport& report() const { return report_; }   ///< valid after `finish`
    const std::string& root() const { return store_.root(); }
    const std::optional<core::Error>& failure() const { return receiver_->failure(); }

private:
    TemporaryFolder folder_;
    io::ObjectStore store_;
    io::TransferReport report_;
    io::ArchiveObserver observe_;
    io::StoreWriter arrivals_;
    int port_ = 0;
    std::optional<io::StorageScp> receiver_;
    mutable std::mutex hearing_;
    core::Messages heard_;
    std::atomic<bool> isOver_{false};
    std::thread thread_;
};

TEST(ArchiveReceiver, TakesWhatIsPushed)
{
    const TemporaryFolder folder;
    const auto files = writeObjects(folder, "2.25.4711.41", 5);
    ServedPort port({});
    const auto report = io::sendToArchive(port.node(), ArchiveProtocol::Dimse, files);
    EXPECT_EQ(report.transferred, 5u) << (report.end ? report.end->message.text() : "");
    const auto again = io::sendToArchive(port.node(), ArchiveProtocol::Dimse, files);
    EXPECT_TRUE(again.isComplete());
    EXPECT_TRUE(io::echoArchive(port.node(), ArchiveProtocol::Dimse));
    port.finish();
    EXPECT_EQ(port.report().transferred, 5u);
    EXPECT_EQ(port.report().duplicates, 5u);
    for (const std::string& file : files) {
        const std::string came = readText(std::filesystem::path(port.root()) / studyUid / "2.25.4711.41" /
                                          std::filesystem::path(file).filename());
        const std::string sent = readText(file);
        const std::size_t dataset =
            sent.find("\x08\0\x05\0"s);   // after the file header, which the receiver writes itself
        ASSERT_NE(dataset, std::string::npos);
        EXPECT_TRUE(came.ends_with(std::string_view(sent).substr(dataset))) << file;
    }
    EXPECT_TRUE(halfFiles(port.root()).empty());
}

TEST(ArchiveReceiver, KeepsTheFirstOfTwoWithOneUid)
{
    const TemporaryFolder folder;
    const std::string first = folder.write("first.dcm", objectText(0, "2.25.4711.42", 64));
    const std::string other = folder.write("other.dcm", objectText(0, "2.25.4711.42", 32));
    ServedPort port({});
    EXPECT_EQ(io::sendToArchive(port.node(), ArchiveProtocol::Dimse, {first}).transferred, 1u);
    EXPECT_EQ(io::sendToArchive(port.node(), ArchiveProtocol::Dimse, {other}).duplicates, 1u);
    port.finish();
    EXPECT_EQ(port.report().transferred, 1u);
    EXPECT_EQ(port.report().failed, 1u);
    EXPECT_TRUE(port.report().problems.at(0).is(io::messages::archiveObjectDiffers));
}

TEST(ArchiveReceiver, TurnsStrangersAway)
{
    io::StorageScpOptions options;
    options.titles = {"MODALITY"};
    ServedPort port(options);
    const auto stranger = io::echoArchive(port.node(), ArchiveProtocol::Dimse);
    ASSERT_FALSE(stranger);
    EXPECT_TRUE(stranger.error().message.is(io::messages::archiveTitleNotAllowed)) << stranger.error().message.text();
    io::ArchiveNode known = port.node();
    known.ownAeTitle = "MODALITY";
    EXPECT_TRUE(io::echoArchive(known, ArchiveProtocol::Dimse));
    known.title = "SOMEBODY";
    const auto miscalled = io::echoArchive(known, ArchiveProtocol::Dimse);
    ASSERT_FALSE(miscalled);
    EXPECT_TRUE(miscalled.error().message.is(io::messages::archiveUnknownTitle));
}

TEST(ArchiveReceiver, TellsOfThoseTurnedAwayAsItHappens)
{
    io::StorageScpOptions options;
    options.titles = {"MODALITY"};
    ServedPort port(options);
    EXPECT_FALSE(io::echoArchive(port.node(), ArchiveProtocol::Dimse));
    io::ArchiveNode miscalled = port.node();
    miscalled.ownAeTitle = "MODALITY";
    miscalled.title = "SOMEBODY";
    EXPECT_FALSE(io::echoArchive(miscalled, ArchiveProtocol::Dimse));
    const core::Messages heard = port.heard();
    ASSERT_EQ(heard.size(), 2u) << "while it serves";
    EXPECT_EQ(heard[0].text(),
              "127.0.0.1 (AE title ANGIOPOSE) was rejected: it is not in the list of allowed calling AE titles.");
    EXPECT_TRUE(heard[1].is(io::messages::archiveCalledOtherwise)) << heard[1].text();
}

TEST(ArchiveReceiver, OptionsAreChecked)
{
    io::StorageScpOptions options;
    EXPECT_TRUE(io::checkStorageScpOptions(options));
    options.titles = {"A TITLE OF MORE THAN 16"};
    ASSERT_FALSE(io::checkStorageScpOptions(options));
    EXPECT_TRUE(io::checkStorageScpOptions(options).error().message.is(io::messages::archiveBadTitle));
    options.titles.clear();
    options.isTls = true;
    ASSERT_FALSE(io::checkStorageScpOptions(options));
    EXPECT_TRUE(io::checkStorageScpOptions(options).error().message.is(io::messages::archivePortUnsecured));
}

TEST(ArchiveReceiver, TurnsStrangeHostsAway)
{
    io::StorageScpOptions options;
    options.hosts = {"10.1.2.3"};
    ServedPort port(options);
    EXPECT_FALSE(io::echoArchive(port.node(), ArchiveProtocol::Dimse));
}

TEST(ArchiveReceiver, SurvivesCutAndTooLargeObjects)
{
    const TemporaryFolder folder;
    const auto large = writeObjects(folder, "2.25.4711.43", 1, 512);
    const auto small = writeObjects(folder, "2.25.4711.44", 1, 32);
    ServedPort port({}, {}, 100'000);
    const auto refused = io::sendToArchive(port.node(), ArchiveProtocol::Dimse, large);
    EXPECT_EQ(refused.transferred, 0u);
    EXPECT_TRUE(refused.end);
    EXPECT_EQ(io::sendToArchive(port.node(), ArchiveProtocol::Dimse, small).transferred, 1u);
    port.finish();
    EXPECT_TRUE(halfFiles(port.root()).empty());
    EXPECT_EQ(port.report().failed, 1u);
}

TEST(ArchiveReceiver, EndsWhenItsFolderIsFull)
{
    const TemporaryFolder folder;
    const auto files = writeObjects(folder, "2.25.4711.45", 3, 128);
    ServedPort port({}, {50'000, io::StoreLimit::FullStorePolicy::Refuse});
    const auto report = io::sendToArchive(port.node(), ArchiveProtocol::Dimse, files);
    EXPECT_EQ(report.transferred, 1u);
    port.finish();
    ASSERT_TRUE(port.failure());
    EXPECT_TRUE(port.failure()->message.is(io::messages::archiveCacheTooSmall));
    EXPECT_EQ(port.report().transferred, 1u);
}

TEST(ArchiveReceiver, TakenPortIsSaid)
{
    const SilentPeer peer;
    io::StorageScpOptions options;
    options.port = peer.port();
    const auto listening = io::StorageScp::listen(options);
    ASSERT_FALSE(listening);
    EXPECT_TRUE(listening.error().message.is(io::messages::archivePortTaken));
}

TEST(ArchiveReceiver, SpeaksTlsWithKnownCertificatesOnly)
{
    const TemporaryFolder folder;
    const auto ours = makeCertificate(folder, "ours");
    const auto theirs = makeCertificate(folder, "theirs");
    const auto stranger = makeCertificate(folder, "stranger");
    if (!ours || !theirs || !stranger) {
        GTEST_SKIP() << "openssl is not installed";
    }
    io::StorageScpOptions options;
    options.isTls = true;
    options.tls = {theirs->certificateFile, ours->certificateFile, ours->keyFile};
    options.responseTimeoutSeconds = 3;
    ServedPort port(options);
    io::ArchiveNode node = port.node();
    node.responseTimeoutSeconds = 3;
    node.isTls = true;
    node.caFile = ours->certificateFile;
    node.certificateFile = theirs->certificateFile;
    node.keyFile = theirs->keyFile;
    const auto files = writeObjects(folder, "2.25.4711.46", 2);
    const auto report = io::sendToArchive(node, ArchiveProtocol::Dimse, files);
    EXPECT_EQ(report.transferred, 2u) << (report.end ? report.end->message.text() : "");

    const Stopwatch watch;
    io::ArchiveNode unknownArchive = node;
    unknownArchive.caFile = stranger->certificateFile;
    const auto refused = io::echoArchive(unknownArchive, ArchiveProtocol::Dimse);
    ASSERT_FALSE(refused);
    expectFailure(refused.error(), io::messages::archiveTlsRefused, watch);

    io::ArchiveNode unknownCaller = node;
    unknownCaller.certificateFile = stranger->certificateFile;
    unknownCaller.keyFile = stranger->keyFile;
    EXPECT_FALSE(io::echoArchive(unknownCaller, ArchiveProtocol::Dimse));

    io::ArchiveNode inTheClear = node;
    inTheClear.isTls = false;
    EXPECT_FALSE(io::echoArchive(inTheClear, ArchiveProtocol::Dimse));
    const core::Messages heard = port.heard();
    EXPECT_GE(
        std::ranges::count_if(heard, [](const auto& each) { return each.is(io::messages::archiveCallNotSecured); }), 2)
        << "refused ones are reported";

    io::ArchiveNode otherHost = node;
    otherHost.host = "127.0.0.2";
    const auto misnamed = io::echoArchive(otherHost, ArchiveProtocol::Dimse);
    ASSERT_FALSE(misnamed);
    EXPECT_TRUE(misnamed.error().message.is(io::messages::archiveTlsHost)) << misnamed.error().message.text();
    otherHost.verifiesHost = false;
    EXPECT_TRUE(io::echoArchive(otherHost, ArchiveProtocol::Dimse));
}

}   // namespace
}   // namespace angiopose::test
