#include "io/archive/dimse/command.h"
#include "io/archive/dimse/identifier.h"
#include "io/archive/model/query.h"
#include "io/archive/node_file.h"
#include "io/archive/web/dicom_json.h"
#include "io/archive/web/multipart.h"
#include "io/messages/messages.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace angiopose::test {
namespace {

TEST(DimseCommand, ComesBackAsItWent)
{
    io::DimseCommand command(io::DimseMessageType::StoreRequest, 7, "1.2.3");
    command.setText(io::DimseCommand::affectedSopInstance, "1.2.3.4");
    command.setHasData();
    const std::string bytes = command.encoded();
    const auto decoded = io::DimseCommand::decode(bytes);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->kind(), io::DimseMessageType::StoreRequest);
    EXPECT_EQ(decoded->text(io::DimseCommand::affectedSopInstance), "1.2.3.4");
    EXPECT_TRUE(decoded->hasData());
    const auto answer = decoded->response(io::dimse::success);
    EXPECT_EQ(answer.kind(), io::DimseMessageType::StoreResponse);
    EXPECT_EQ(answer.number(io::DimseCommand::respondedMessageId), 7);
    for (std::size_t size = 1; size < bytes.size(); ++size) {   // truncated anywhere: no command, or a shorter one
        (void)io::DimseCommand::decode(std::string_view(bytes).substr(0, size));
    }
    EXPECT_FALSE(io::DimseCommand::decode("nonsense"));
}

TEST(Identifier, SaysThatItsTextsAreUtf8)
{
    const auto data = io::decodeIdentifier(io::encodeIdentifier({{0x00100010, "Müller"}, {0x0020000d, "1.2.3"}}));
    EXPECT_EQ(data.text(0x00080005), "ISO_IR 192");
    EXPECT_EQ(data.text(0x00100010), "Müller");
    EXPECT_EQ(data.text(0x0020000d), "1.2.3");
}

TEST(ArchiveQuery, TakesDatesAndRanges)
{
    EXPECT_EQ(io::parseQueryDates("2024-01-31").value(), "20240131");
    EXPECT_EQ(io::parseQueryDates("20240131..2024-02-01").value(), "20240131-20240201");
    EXPECT_EQ(io::parseQueryDates("2024-01-31..").value(), "20240131-");
    EXPECT_EQ(io::parseQueryDates("").value(), "");
    for (const char* wrong : {"..", "yesterday", "2024-13-01", "2024-01-01..x"}) {
        EXPECT_FALSE(io::parseQueryDates(wrong)) << wrong;
    }
}

TEST(ArchiveQuery, UidsAreFitForFileNames)
{
    EXPECT_TRUE(io::isUid("1.2.840.10008"));
    for (const char* wrong : {"", "..", "1..2", "1.", ".1", "1/2", "a", "1.2 "}) {
        EXPECT_FALSE(io::isUid(wrong)) << wrong;
    }
}

std::vector<std::string> partsOf(const std::string& body, std::size_t pieceSize, bool& isClosed)
{
    std::vector<std::string> parts;
    io::MultipartReader reader("b", {[&parts] {
                                         parts.emplace_back();
                                         return core::Status(core::Done{});
                                     },
                                     [&parts](std::string_view bytes) {
                                         parts.back() += bytes;
                                         return core::Status(core::Done{});
                                     },
                                     [] { return core::Status(core::Done{}); }});
    for (std::size_t at = 0; at < body.size(); at += pieceSize) {
        if (!reader.feed(std::string_view(body).substr(at, pieceSize))) {
            break;
        }
    }
    isClosed = reader.isClosed();
    return parts;
}

TEST(Multipart, PartsDoNotDependOnThePieces)
{
    const std::string body =
        "preamble\r\n--b\r\nContent-Type: x\r\n\r\none\r\n-\r\n--b\r\n\r\n\r\n--b\r\nA: b\r\n\r\nthree"
        "\r\n--b--\r\nepilogue";
    for (const std::size_t size : {1, 2, 3, 7, 1000}) {
        bool isClosed = false;
        EXPECT_EQ(partsOf(body, size, isClosed), (std::vector<std::string>{"one\r\n-", "", "three"}));
        EXPECT_TRUE(isClosed);
        partsOf(body.substr(0, body.size() - 14), size, isClosed);
        EXPECT_FALSE(isClosed);
    }
}

TEST(Multipart, EndlessHeadersAreRefused)
{
    bool isClosed = false;
    EXPECT_TRUE(partsOf("--b\r\nA: " + std::string(100'000, 'x'), 1000, isClosed).empty());
    EXPECT_EQ(io::parseBoundary("multipart/related; type=\"application/dicom\"; boundary=\"a b\""), "a b");
    EXPECT_EQ(io::parseBoundary("Multipart/Related; Boundary=xyz; type=y"), "xyz");
    EXPECT_FALSE(io::parseBoundary("application/dicom"));
    EXPECT_FALSE(io::parseBoundary("multipart/related; boundary=" + std::string(71, 'x')));
}

TEST(DicomJson, ReadsMatchesAndRefusesOther)
{
    const auto found = io::parseMatches(
        R"([{"00100010":{"vr":"PN","Value":[{"Alphabetic":"A^B"}]},"0020000D":{"vr":"UI","Value":["1.2"]},
             "00080061":{"vr":"CS","Value":["CT","XA"]},"00201208":{"vr":"IS","Value":[3]}}])");
    ASSERT_TRUE(found);
    EXPECT_EQ(found.value().at(0).patientName, "A^B");
    EXPECT_EQ(found.value().at(0).modalities, "CT\\XA");
    EXPECT_EQ(found.value().at(0).objects, 3);
    EXPECT_TRUE(io::parseMatches("").value().empty());
    for (const char* wrong : {"{", "{}", "[1]", "<html>"}) {
        EXPECT_FALSE(io::parseMatches(wrong)) << wrong;
    }
    EXPECT_TRUE(io::parseMatches(R"([{"00100010":7,"0020000D":{"Value":{}}}])"));
}

TEST(NodeFile, KeepsNodesAndNamesWhatIsWrong)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("deep/archives.json");
    EXPECT_TRUE(io::readArchiveSettings(path).value().nodes.empty());
    io::ArchiveSettings settings;
    settings.cacheBytes = 5'000'000'000;
    io::ArchiveNode node;
    node.name = "pacs";
    node.host = "pacs.example";
    node.isTls = true;
    node.keyFile = "/k.pem";
    node.certificateFile = "/c.pem";
    node.verifiesHost = false;
    settings.nodes = {node};
    ASSERT_TRUE(io::writeArchiveSettings(settings, path));
    const auto read = io::readArchiveSettings(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().cacheBytes, settings.cacheBytes);
    const auto found = io::findNode(read.value(), "pacs", path);
    ASSERT_TRUE(found);
    EXPECT_EQ(found.value().keyFile, "/k.pem");
    EXPECT_FALSE(found.value().verifiesHost);
    const auto unknown = io::findNode(read.value(), "pax", path);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.text().find("available: pacs"), std::string::npos);
    writeText(path, R"({"format":"angiopose-archives","version":1,"nodes":[{"name":"x","port":"many"}]})");
    EXPECT_TRUE(io::readArchiveSettings(path).error().message.is(io::messages::archiveListInvalid));
    node.host = "a b";
    EXPECT_TRUE(io::checkNode(node).error().message.is(io::messages::archiveBadHost));
}

}   // namespace
}   // namespace angiopose::test
