#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/faulty_peers.h"
#include "tests/io/archive/orthanc.h"

#include "io/angiogram_file.h"
#include "io/archive/dimse/get_series.h"
#include "io/archive/store/cache.h"
#include "io/messages/messages.h"

#include <signal.h>
#include <sys/resource.h>

namespace angiopose::test {
namespace {

using io::ArchiveProtocol;

/// One archive for the whole suite, because it takes seconds to start.
class ArchiveExchange : public testing::Test {
protected:
    static void SetUpTestSuite() { orthanc_ = std::make_unique<Orthanc>(); }
    static void TearDownTestSuite() { orthanc_.reset(); }

    void SetUp() override
    {
        if (!orthanc_->isRunning()) {
            GTEST_SKIP() << orthanc_->whyNot();
        }
    }

    static io::ArchiveNode node()
    {
        io::ArchiveNode node;
        node.name = "pacs";
        node.host = "127.0.0.1";
        node.port = orthanc_->dicomPort();
        node.title = Orthanc::title;
        node.webUrl = orthanc_->webUrl();
        node.caFile = orthanc_->caFile();
        return node;
    }

    /// Sends a series that the archive then stores.
    std::vector<std::string> sent(const std::string& seriesUid, int count, int side = 64)
    {
        auto files = writeObjects(folder_, seriesUid, count, side);
        const auto report = io::sendToArchive(node(), ArchiveProtocol::Dimse, files);
        EXPECT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : "");
        EXPECT_EQ(report.transferred + report.duplicates, files.size());
        return files;
    }

    io::TransferReport retrieved(ArchiveProtocol way, const std::string& seriesUid, const io::ObjectStore& store,
                                 const io::ArchiveObserver& observe = {})
    {
        return io::retrieveFromArchive(node(), way, {studyUid, {seriesUid}}, store, {}, observe);
    }

    TemporaryFolder folder_;
    static inline std::unique_ptr<Orthanc> orthanc_;
};

/// Expects every sent object in the store with the same pixels and UIDs.
void expectSame(const std::vector<std::string>& files, const std::string& folder)
{
    for (const std::string& file : files) {
        const auto came = std::filesystem::path(folder) / std::filesystem::path(file).filename();
        const auto before = io::readAngiogram(file), after = io::readAngiogram(came.string());
        ASSERT_TRUE(before && after) << came;
        EXPECT_EQ(before.value().frames.front().pixels, after.value().frames.front().pixels);
        EXPECT_EQ(before.value().identity.sopInstanceUid, after.value().identity.sopInstanceUid);
        EXPECT_EQ(before.value().identity.patientName, after.value().identity.patientName);
    }
}

TEST_F(ArchiveExchange, AnswersEchoBothWays)
{
    EXPECT_TRUE(io::echoArchive(node(), ArchiveProtocol::Dimse));
    const auto web = io::echoArchive(node(), ArchiveProtocol::Web);
    EXPECT_TRUE(web) << web.error().message.text();
}

TEST_F(ArchiveExchange, OfAFolderDicomFilesGoAndDamagedOnesAreNamed)
{
    const auto files = writeObjects(folder_, "2.25.4711.41", 2, 16);
    const auto parent = std::filesystem::path(files.front()).parent_path();
    std::filesystem::create_directories(parent / "export");
    std::filesystem::copy_file(files.front(), parent / "export" / "a.dcm");
    writeText(parent / "export" / "camera.json", "{}");
    const auto whole = io::sendToArchive(node(), ArchiveProtocol::Dimse, {(parent / "export").string()});
    EXPECT_TRUE(whole.isComplete());
    EXPECT_EQ(whole.transferred + whole.duplicates, 1U);
    writeText(parent / "export" / "b.dcm", "nothing of DICOM");
    EXPECT_FALSE(io::sendToArchive(node(), ArchiveProtocol::Dimse, {(parent / "export").string()}).isComplete());
}

TEST_F(ArchiveExchange, TwentyObjectsComeBackTheSame)
{
    const std::string series = "2.25.4711.20";
    const auto files = sent(series, 20);
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const std::string into = folder_.file(way == ArchiveProtocol::Web ? "web" : "dimse");
        const auto store = openStore(into);
        const auto report = retrieved(way, series, store);
        ASSERT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : report.problems.at(0).text());
        EXPECT_EQ(report.all, 20u);
        EXPECT_EQ(report.transferred, 20u);
        expectSame(files, report.folders.at(0));
        EXPECT_TRUE(halfFiles(into).empty());
        EXPECT_TRUE(io::listCachedSeries(into).at(0).isComplete);
    }
}

TEST_F(ArchiveExchange, MoveBringsTheSame)
{
    const std::string series = "2.25.4711.21";
    const auto files = sent(series, 3);
    io::ArchiveNode mover = node();
    mover.receivePort = orthanc_->movePort();
    const auto store = openStore(folder_.file("moved"));
    io::TransferReport report;
    const io::ArchiveObserver observe;
    io::StoreWriter storeWriter(store, {}, report, observe);
    const std::vector<io::ArchiveObject> objects;
    const auto moved = io::moveSeries(mover, {studyUid, series, objects}, storeWriter);
    ASSERT_TRUE(moved) << moved.error().message.text();
    EXPECT_EQ(report.transferred, 3u);
    expectSame(files, store.seriesFolder(studyUid, series));
}

TEST_F(ArchiveExchange, FindsTheSameBothWays)
{
    sent("2.25.4711.22", 2);
    io::ArchiveQuery query;
    query.dates = "20240301-20240331";
    query.modality = "XA";
    query.level = io::ArchiveLevel::Series;
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        query.patientName = way == ArchiveProtocol::Web ? "M" : "Müll";   // this Orthanc expects URL queries in Latin-1
        const auto matches = io::queryArchive(node(), way, query);
        ASSERT_TRUE(matches) << matches.error().message.text();
        const auto& found = matches.value().found;
        const auto match = std::ranges::find(found, "2.25.4711.22", &io::ArchiveMatch::seriesUid);
        ASSERT_NE(match, found.end());
        EXPECT_EQ(match->patientName, "Müller^Änne");
        EXPECT_EQ(match->studyUid, studyUid);
        EXPECT_EQ(match->objects, 2);
        EXPECT_EQ(match->modalities, "XA");
    }
    query.dates = "20250101-";
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const auto none = io::queryArchive(node(), way, query);
        ASSERT_TRUE(none);
        EXPECT_TRUE(none.value().found.empty());
    }
}

TEST_F(ArchiveExchange, WebStoresWhatIsSent)
{
    const std::string series = "2.25.4711.23";
    const auto files = writeObjects(folder_, series, 2);
    const auto report = io::sendToArchive(node(), ArchiveProtocol::Web, files);
    ASSERT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : report.problems.at(0).text());
    const auto back = retrieved(ArchiveProtocol::Dimse, series, openStore(folder_.file("back")));
    EXPECT_EQ(back.transferred, 2u);
    expectSame(files, back.folders.at(0));
}

TEST_F(ArchiveExchange, WhatIsThereIsNotFetchedAgain)
{
    const std::string series = "2.25.4711.24";
    sent(series, 3);
    const auto store = openStore(folder_.file("cache"));
    EXPECT_EQ(retrieved(ArchiveProtocol::Dimse, series, store).transferred, 3u);
    const auto again = retrieved(ArchiveProtocol::Dimse, series, store);
    EXPECT_EQ(again.transferred, 0u);
    EXPECT_EQ(again.duplicates, 3u);
    std::filesystem::remove(store.seriesFolder(studyUid, series) + "/" + series + ".2.dcm");
    const auto mended = retrieved(ArchiveProtocol::Dimse, series, store);
    EXPECT_EQ(mended.transferred, 1u);
    EXPECT_EQ(mended.duplicates, 2u);
}

TEST_F(ArchiveExchange, WrongTitleIsSaid)
{
    io::ArchiveNode wrong = node();
    wrong.title = "NOBODY";
    const Stopwatch watch;
    const auto echoed = io::echoArchive(wrong, ArchiveProtocol::Dimse);
    ASSERT_FALSE(echoed);
    expectFailure(echoed.error(), io::messages::archiveUnknownTitle, watch);
    EXPECT_NE(echoed.error().message.text().find("pacs"), std::string::npos);
}

TEST_F(ArchiveExchange, UnknownCertificateIsRefused)
{
    const TemporaryFolder other;
    io::ArchiveNode stranger = node();
    stranger.caFile = makeCertificate(other, "stranger")->certificateFile;
    const Stopwatch watch;
    const auto web = io::echoArchive(stranger, ArchiveProtocol::Web);
    ASSERT_FALSE(web);
    expectFailure(web.error(), io::messages::archiveTlsRefused, watch);
    stranger.isTls = true;   // on a port without TLS
    const auto dimse = io::echoArchive(stranger, ArchiveProtocol::Dimse);
    ASSERT_FALSE(dimse);
    expectFailure(dimse.error(), io::messages::archiveTlsRefused, watch);
}

TEST_F(ArchiveExchange, CutTransferLeavesWholeObjectsOnly)
{
    const std::string series = "2.25.4711.25";
    sent(series, 6, 256);
    CuttingProxy proxy(orthanc_->dicomPort(), 500'000);
    io::ArchiveNode cut = node();
    cut.port = proxy.port();
    const std::string into = folder_.file("cut");
    const auto store = openStore(into);
    const Stopwatch watch;
    const auto report = io::retrieveFromArchive(cut, ArchiveProtocol::Dimse, {studyUid, {series}}, store, {});
    ASSERT_TRUE(report.end);
    expectFailure(*report.end, io::messages::archiveBroken, watch);
    EXPECT_GT(report.transferred, 0u);
    EXPECT_LT(report.transferred, 6u);
    EXPECT_TRUE(halfFiles(into).empty());
    EXPECT_FALSE(io::listCachedSeries(into).at(0).isComplete);
    proxy.heal();
    const auto again = io::retrieveFromArchive(cut, ArchiveProtocol::Dimse, {studyUid, {series}}, store, {});
    EXPECT_TRUE(again.isComplete());
    EXPECT_EQ(again.transferred + again.duplicates, 6u);
    EXPECT_TRUE(io::listCachedSeries(into).at(0).isComplete);
}

TEST_F(ArchiveExchange, HangingTransferIsGivenUp)
{
    const std::string series = "2.25.4711.29";
    sent(series, 3, 256);
    const CuttingProxy proxy(orthanc_->dicomPort(), 200'000, CuttingProxy::AtEnd::Hang);
    io::ArchiveNode hanging = node();
    hanging.port = proxy.port();
    hanging.responseTimeoutSeconds = 3;
    const std::string into = folder_.file("hang");
    const auto store = openStore(into);
    const Stopwatch watch;
    const auto report = io::retrieveFromArchive(hanging, ArchiveProtocol::Dimse, {studyUid, {series}}, store, {});
    ASSERT_TRUE(report.end);
    EXPECT_LT(watch.seconds(), 8.0);
    EXPECT_LT(report.transferred, 3u);
    EXPECT_TRUE(halfFiles(into).empty());
}

TEST_F(ArchiveExchange, StopInTheMiddleKeepsWholeObjects)
{
    const std::string series = "2.25.4711.26";
    sent(series, 8, 256);
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const std::string into = folder_.file(way == ArchiveProtocol::Web ? "stop-web" : "stop-dimse");
        const auto store = openStore(into);
        const auto report = retrieved(way, series, store, [](const io::ArchiveProgress& progress) {
            return progress.objects >= 2 ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        ASSERT_TRUE(report.end);
        EXPECT_TRUE(report.end->isCancellation()) << report.end->message.text();
        EXPECT_LT(report.transferred, 8u);
        EXPECT_TRUE(halfFiles(into).empty());
    }
}

TEST_F(ArchiveExchange, TooLargeObjectIsNotKept)
{
    const std::string series = "2.25.4711.27";
    sent(series, 1, 256);
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const std::string into = folder_.file(way == ArchiveProtocol::Web ? "large-web" : "large-dimse");
        const auto report = retrieved(way, series, openStore(into, 20'000));
        ASSERT_TRUE(report.end);
        EXPECT_TRUE(report.end->message.is(io::messages::archiveObjectTooLarge)) << report.end->message.text();
        EXPECT_EQ(report.transferred, 0u);
        EXPECT_TRUE(halfFiles(into).empty());
    }
}

/// Limits the size of every file of this process, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        ::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

TEST_F(ArchiveExchange, FullDiskIsSaid)
{
    const std::string series = "2.25.4711.28";
    sent(series, 2, 256);
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const std::string into = folder_.file(way == ArchiveProtocol::Web ? "full-web" : "full-dimse");
        const auto store = openStore(into);
        const Stopwatch watch;
        const FullDisk full(30'000);
        const auto report = retrieved(way, series, store);
        ASSERT_TRUE(report.end);
        expectFailure(*report.end, io::messages::fileBeyondLimit, watch);
        EXPECT_EQ(report.transferred, 0u);
        EXPECT_TRUE(halfFiles(into).empty());
    }
}

TEST_F(ArchiveExchange, CacheDropsTheLongestUnusedFirst)
{
    sent("2.25.4711.31", 2, 128);
    sent("2.25.4711.32", 2, 128);
    const auto store = openStore(folder_.file("small"));
    const io::StoreLimit limit{100'000, io::StoreLimit::FullStorePolicy::DeleteOldest};
    for (const char* series : {"2.25.4711.31", "2.25.4711.32"}) {
        const auto report = io::retrieveFromArchive(node(), ArchiveProtocol::Dimse, {studyUid, {series}}, store, limit);
        EXPECT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : "");
    }
    const auto held = io::listCachedSeries(store.root());
    ASSERT_EQ(held.size(), 1u);
    EXPECT_EQ(held.front().seriesUid, "2.25.4711.32");
    const auto dropped = io::clearCache(store.root());
    ASSERT_TRUE(dropped);
    EXPECT_EQ(dropped.value(), 2u);
    EXPECT_TRUE(io::listCachedSeries(store.root()).empty());
    const io::StoreLimit tiny{40'000, io::StoreLimit::FullStorePolicy::DeleteOldest};
    const auto report =
        io::retrieveFromArchive(node(), ArchiveProtocol::Dimse, {studyUid, {"2.25.4711.31"}}, store, tiny);
    ASSERT_TRUE(report.end);
    EXPECT_TRUE(report.end->message.is(io::messages::archiveCacheTooSmall));
}

TEST_F(ArchiveExchange, DuplicateIsSentWithoutHarm)
{
    const std::string series = "2.25.4711.33";
    const auto files = sent(series, 1);
    for (const ArchiveProtocol way : {ArchiveProtocol::Dimse, ArchiveProtocol::Web}) {
        const auto report = io::sendToArchive(node(), way, files);
        EXPECT_TRUE(report.isComplete());
        EXPECT_EQ(report.transferred + report.duplicates, 1u);
    }
    EXPECT_EQ(retrieved(ArchiveProtocol::Dimse, series, openStore(folder_.file("one"))).transferred, 1u);
}

TEST_F(ArchiveExchange, WhatIsNoWholeObjectIsNotSent)
{
    const std::string text = objectText(0, "2.25.4711.34");
    const std::string cut = folder_.write("cut.dcm", text.substr(0, text.size() - 1000));
    const std::string other = folder_.write("notes.txt", "no image");
    const auto report = io::sendToArchive(node(), ArchiveProtocol::Dimse, {cut, other});
    EXPECT_EQ(report.failed, 2u);
    EXPECT_EQ(report.transferred, 0u);
    EXPECT_TRUE(report.problems.at(0).is(io::messages::archiveNotSendable));
}

}   // namespace
}   // namespace angiopose::test
