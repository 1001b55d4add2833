#include "io/decode/ask_decoder.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <chrono>

using namespace angiopose;

// Uses the shell as a helper program that behaves like decoders on damaged files.

namespace {

core::Result<io::DecoderReply> asked(const std::string& script, const io::ReadObserver& observe = {})
{
    return io::runDecoder("/bin/sh", {"-c", script}, "file.ply", observe);
}

std::string idOf(const core::Result<io::DecoderReply>& reply)
{
    return reply ? "replied" : std::string(reply.error().message.id());
}

const std::string five = R"(printf '\311\005\000\000\000\000\000\000\000')";   // announces a result of five bytes

}   // namespace

TEST(AskDecoder, TakesAWholeReplyAfterProgress)
{
    double last = 0.0;
    const auto reply = asked("printf '\\024'; sleep 0.2; printf '\\120'; sleep 0.2; " + five + "; printf hello",
                             [&last](double fraction) {
                                 EXPECT_GE(fraction, last);
                                 last = fraction;
                                 return core::ObserverDecision::Continue;
                             });
    ASSERT_TRUE(reply) << reply.error().message;
    EXPECT_EQ(reply.value().content, "hello");
    EXPECT_GE(last, 0.7);
}

TEST(AskDecoder, NamesTheFileOfADecoderThatDies)
{
    EXPECT_EQ(idOf(asked("kill -SEGV $$")), "file.decoder-died");
    EXPECT_EQ(idOf(asked(five + "; printf hell; kill -ABRT $$")), "file.decoder-died");
    EXPECT_EQ(idOf(asked("kill -XCPU $$")), "file.decoder-too-long");
    EXPECT_EQ(asked("kill -SEGV $$").error().message.subject(), "file.ply");
}

TEST(AskDecoder, TrustsNoReplyThatIsNotWhole)
{
    EXPECT_EQ(idOf(asked("exit 0")), "file.decoder-died");
    EXPECT_EQ(idOf(asked(five + "; printf hell")), "file.decoder-died");
    EXPECT_EQ(idOf(asked(five + "; printf hello!")), "file.decoder-died");
    EXPECT_EQ(idOf(asked("printf '\\311\\377\\377\\377\\377\\377\\377\\377\\377'; yes")), "file.decoder-died");
    EXPECT_EQ(idOf(io::runDecoder("no-such-helper", {}, "file.ply")), "file.decoder-missing");
}

TEST(AskDecoder, StopsAProgramThatDoesNotEnd)
{
    const auto start = std::chrono::steady_clock::now();
    const auto reply = asked("exec sleep 60", [&start](double) {
        return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(200)
                   ? core::ObserverDecision::Stop
                   : core::ObserverDecision::Continue;
    });
    EXPECT_TRUE(reply.isStopped());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(DecoderReply, GivesBackWhatWasPutIn)
{
    const std::map<std::string, std::vector<double>> arrays{{"Radius", {1.0, 0.1}}, {"", {}}};
    const std::vector<std::string> names{"LAD", ""};
    const std::vector<std::vector<std::uint64_t>> lines{{0, 1}, {}, {7}};
    io::ReplyWriter writer;
    writer.put(arrays);
    writer.put(names);
    writer.put(lines);
    const std::string bytes = std::move(writer).bytes();

    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        std::map<std::string, std::vector<double>> readArrays;
        std::vector<std::string> readNames;
        std::vector<std::vector<std::uint64_t>> readLines;
        io::ReplyReader reader(std::string_view(bytes).substr(0, size));
        reader.take(readArrays);
        reader.take(readNames);
        reader.take(readLines);
        ASSERT_EQ(reader.isDone(), size == bytes.size()) << size;
        if (reader.isDone()) {
            EXPECT_EQ(readArrays, arrays);
            EXPECT_EQ(readNames, names);
            EXPECT_EQ(readLines, lines);
        }
    }
}
