#include "tests/cli/batch_files.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using nlohmann::json;
using test::readText;
using test::runCli;
using test::writeText;

std::ptrdiff_t linesOf(const std::string& path)
{
    const std::string text = readText(path);
    return std::count(text.begin(), text.end(), '\n');
}

/// Fixture: small simulated cases in a separate folder, and a manifest of them.
class CliBatch : public testing::Test {
protected:
    void simulate(int count)
    {
        std::string rows = "case,name\n";
        for (int i = 1; i <= count; ++i) {
            const std::string name = "c" + std::to_string(i);
            ASSERT_EQ(
                runCli({"simulate", "--seed", std::to_string(i), "--branches", "6", "--output", folder_.file(name)})
                    .exitCode,
                0);
            rows += name + "/case.angiopose," + name + "\n";
        }
        writeText(manifest_, rows);
    }

    test::ProgramOutcome batch(const std::string& output, std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments{"batch", manifest_, "--output", folder_.file(output)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }

    std::string in(const std::string& name) const { return folder_.file(name); }
    std::string summaryOf(const std::string& output) const { return readText(in(output + "/summary.csv")); }

    const test::TemporaryFolder folder_;
    const std::string manifest_ = folder_.file("cases.csv");
};

TEST_F(CliBatch, WrongUsageAndBrokenManifestsAreReported)
{
    EXPECT_EQ(runCli({"batch"}).exitCode, 2);
    EXPECT_EQ(runCli({"batch", manifest_}).exitCode, 2);
    EXPECT_EQ(batch("out").exitCode, 3);
    for (const std::string text :
         {"", "path\na.angiopose\n", "case\n", "case,frame\na.angiopose,second\n", "case,name\na.angiopose,x/y\n",
          "case,name\na.angiopose,x\nb.angiopose,x\n", "case,name\n,x\n", "vessels,angiogram\na.vtp,\n",
          "case,vessels,angiogram\na.angiopose,b.vtp,c.png\n", "vessels,angiogram,seeds\na.nii,b.png,1 2\n"}) {
        writeText(manifest_, text);
        const auto outcome = batch("out");
        EXPECT_EQ(outcome.exitCode, 3) << text;
        EXPECT_NE(outcome.messages.find("cases.csv"), std::string::npos) << outcome.messages;
    }
    writeText(manifest_, "case\na.angiopose\n");
    EXPECT_EQ(batch("out", {"--shard", "2"}).exitCode, 2);
    EXPECT_EQ(batch("out", {"--set", "priorWeigth=2"}).exitCode, 2);
    EXPECT_EQ(batch("out", {"--merge", "out", "--shard", "1/2"}).exitCode, 2);
    EXPECT_FALSE(fs::exists(in("out/summary.csv")));
}

TEST_F(CliBatch, WrongSettingsAreToldWithLineAndColumnAndTheNearestNames)
{
    const auto reported = [this](const std::string& text) {
        writeText(manifest_, text);
        const auto outcome = batch("out");
        EXPECT_EQ(outcome.exitCode, 3) << text;
        return outcome.messages;
    };
    const std::string misspelt = reported("case,set.priorWeigth\na.angiopose,\n");
    EXPECT_NE(misspelt.find("line 1, column set.priorweigth"), std::string::npos) << misspelt;
    EXPECT_NE(misspelt.find("Closest names: priorWeight."), std::string::npos) << misspelt;
    const std::string bare = reported("case,set.sensitivity\na.angiopose,2\n");
    EXPECT_NE(bare.find("angiogram.trace.sensitivity"), std::string::npos) << bare;
    const std::string value = reported("case,set.priorWeight\na.angiopose,1\nb.angiopose,much\n");
    EXPECT_NE(value.find("line 3, column set.priorweight: "), std::string::npos) << value;
    const std::string tracing = reported("case,set.angiogram.trace.sensitivity\na.angiopose,1000\n");
    EXPECT_NE(tracing.find("line 2, column set.angiogram.trace.sensitivity"), std::string::npos) << tracing;
    EXPECT_FALSE(fs::exists(in("out/summary.csv")));
}

TEST_F(CliBatch, AFailingCaseDoesNotStopTheOthers)
{
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--output", in("demo")}).exitCode, 0);
    writeText(in("broken.angiopose"), "{");
    writeText(manifest_,
              "case,name,method,frame\n"
              "broken.angiopose,,,\n"
              "missing.angiopose,,,\n"
              "demo/case.angiopose,good,,\n"
              "demo/case.angiopose,magic,magic,\n"
              "demo/case.angiopose,far,,99\n");
    const auto outcome = batch("out");
    EXPECT_EQ(outcome.exitCode, 3) << outcome.messages;
    EXPECT_TRUE(fs::exists(in("out/good/result.json")));
    EXPECT_TRUE(fs::exists(in("out/good/overlay.png")));
    EXPECT_FALSE(fs::exists(in("out/far/result.json")));
    const std::string summary = summaryOf("out");
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 6);
    EXPECT_NE(summary.find("1,\"0001-broken\","), std::string::npos) << summary;
    EXPECT_NE(summary.find("3,\"good\","), std::string::npos) << summary;
    EXPECT_NE(summary.find(",done,angiopose,1,"), std::string::npos) << summary;
    EXPECT_NE(summary.find("frame 99 does not exist"), std::string::npos) << summary;
    EXPECT_EQ(linesOf(in("out/times.csv")), 6);
}

TEST_F(CliBatch, TheTableIsTheSameForAnyThreadsShardsAndMerges)
{
    simulate(4);
    ASSERT_EQ(batch("one", {"--threads", "1"}).exitCode, batch("two", {"--threads", "2"}).exitCode);
    EXPECT_EQ(summaryOf("one"), summaryOf("two"));
    EXPECT_EQ(linesOf(in("one/summary.csv")), 5);

    // Two shards write to one folder at the same time: neither overwrites the other's rows.
    auto other = std::async(std::launch::async, [&] { return batch("both", {"--shard", "1/2", "--threads", "1"}); });
    batch("both", {"--shard", "2/2", "--threads", "1"});
    other.get();
    EXPECT_EQ(linesOf(in("both/summary-1-of-2.csv")), 3);
    EXPECT_EQ(linesOf(in("both/summary-2-of-2.csv")), 3);
    EXPECT_EQ(summaryOf("both"), summaryOf("one"));
    EXPECT_EQ(test::lastingContentOf(in("both")), test::lastingContentOf(in("one")));

    // Two shards on two machines, merged.
    batch("a", {"--shard", "1/2"});
    EXPECT_FALSE(fs::exists(in("a/summary.csv")));
    const auto half = batch("merged", {"--merge", in("a")});
    EXPECT_EQ(half.exitCode, 3);
    EXPECT_NE(half.messages.find("c2: "), std::string::npos) << half.messages;
    EXPECT_NE(summaryOf("merged").find("2,\"c2\",\"c2/case.angiopose\",missing,"), std::string::npos);
    batch("b", {"--shard", "2/2"});
    batch("merged", {"--merge", in("a"), in("b")});
    EXPECT_EQ(summaryOf("merged"), summaryOf("one"));
    batch("c", {"--shard", "2/2", "--set", "priorWeight=0.5"});
    const auto mixed = batch("mixed", {"--merge", in("a"), in("c")});
    EXPECT_EQ(mixed.exitCode, 3);
    EXPECT_FALSE(fs::exists(in("mixed/summary.csv"))) << mixed.messages;
}

TEST_F(CliBatch, AllViewsAreRegisteredTogetherAsRegisterDoes)
{
    simulate(1);
    json session = json::parse(readText(in("c1/case.angiopose")));
    session["views"] = json::array({json{{"path", "case.angiopose"}}});
    writeText(in("c1/joint.angiopose"), session.dump());
    writeText(manifest_, "case,name\nc1/joint.angiopose,joint\n");
    batch("out");
    runCli({"register", in("c1/joint.angiopose"), "--output", in("alone/joint")});
    ASSERT_TRUE(fs::exists(in("out/joint/joint.json")));
    ASSERT_TRUE(fs::exists(in("out/joint/view-2/result.json")));
    auto ofBatch = test::lastingContentOf(in("out/joint"));
    EXPECT_EQ(ofBatch.erase("outcome.json"), 1U);
    EXPECT_EQ(ofBatch, test::lastingContentOf(in("alone/joint")));
    EXPECT_NE(summaryOf("out").find(",angiopose,2,"), std::string::npos) << summaryOf("out");
}

TEST_F(CliBatch, ARowHasSettingsOfItsOwn)
{
    simulate(1);
    writeText(manifest_,
              "case,name,set.priorWeight,set.angiogram.trace.sensitivity\n"
              "c1/case.angiopose,own,,\n"
              "c1/case.angiopose,prior,0.25,\n"
              "c1/case.angiopose,traced,,0.3\n");
    batch("out", {"--set", "priorWeight=0.5"});
    const auto optionsOf = [&](const std::string& name) {
        return json::parse(readText(in("out/" + name + "/result.json"))).at("options");
    };
    EXPECT_EQ(optionsOf("own")["priorWeight"], 0.5);
    EXPECT_EQ(optionsOf("prior")["priorWeight"], 0.25);
    EXPECT_EQ(optionsOf("traced")["priorWeight"], 0.5);
    EXPECT_NE(readText(in("out/own/pose.tfm")), readText(in("out/traced/pose.tfm")));
    runCli({"register", in("c1/case.angiopose"), "--set", "priorWeight=0.25", "--output", in("alone")});
    EXPECT_EQ(readText(in("out/prior/pose.tfm")), readText(in("alone/pose.tfm")));
}

TEST_F(CliBatch, ARowMayNameVesselsAndAnAngiogramInsteadOfACase)
{
    simulate(1);
    writeText(manifest_, "vessels,angiogram,name,frame\nc1/tree.vtp,c1/angiogram.dcm,inputs,2\n");
    const auto outcome = batch("out");
    EXPECT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    const json result = json::parse(readText(in("out/inputs/result.json")));
    EXPECT_EQ(result["inputs"]["frame"], 1) << "the table counts from 1, JSON from 0";
    EXPECT_EQ(result["inputs"]["vessel"]["file"], "tree.vtp");
    EXPECT_NE(summaryOf("out").find("\"c1/angiogram.dcm\""), std::string::npos);
}

TEST_F(CliBatch, WithoutPicturesTheTableIsTheSame)
{
    simulate(2);
    batch("drawn");
    batch("bare", {"--no-pictures"});
    EXPECT_EQ(summaryOf("bare"), summaryOf("drawn"));
    EXPECT_TRUE(fs::exists(in("drawn/c1/overlay.png")));
    EXPECT_FALSE(fs::exists(in("bare/c1/overlay.png")));
    EXPECT_EQ(readText(in("bare/c1/pose.tfm")), readText(in("drawn/c1/pose.tfm")));
    EXPECT_NE(batch("bare", {"--no-pictures", "--resume"}).messages.find("2 cases are already completed"),
              std::string::npos);
}

TEST_F(CliBatch, ResumingLeavesWhatIsDoneAndUpToDate)
{
    simulate(3);
    batch("out");
    const auto timeOf = [&](const std::string& name) {
        return fs::last_write_time(in("out/" + name + "/outcome.json"));
    };
    const auto first = timeOf("c1");
    const auto second = timeOf("c2");
    const auto third = timeOf("c3");
    const std::string summary = summaryOf("out");
    fs::remove(in("out/c2/pose.tfm"));   // makes an outcome incomplete
    const auto now = fs::file_time_type::clock::now();
    fs::last_write_time(in("c1/angiogram.dcm"), now);   // changes the time stamp, not the content
    const auto again = batch("out", {"--resume"});
    EXPECT_NE(again.messages.find("2 cases are already completed, 1 remain"), std::string::npos) << again.messages;
    EXPECT_EQ(timeOf("c1"), first);
    EXPECT_EQ(timeOf("c3"), third);
    EXPECT_NE(timeOf("c2"), second);
    EXPECT_TRUE(fs::exists(in("out/c2/pose.tfm")));
    EXPECT_EQ(summaryOf("out"), summary);

    // A different input or different settings: computed again.
    fs::copy_file(in("c2/angiogram.dcm"), in("c1/angiogram.dcm"), fs::copy_options::overwrite_existing);
    const auto changed = batch("out", {"--resume"});
    EXPECT_NE(changed.messages.find("2 cases are already completed, 1 remain"), std::string::npos) << changed.messages;
    const auto other = batch("out", {"--resume", "--set", "priorWeight=0.5"});
    EXPECT_NE(other.messages.find("0 cases are already completed, 3 remain"), std::string::npos) << other.messages;
}

pid_t waitForWorker()
{
    for (int i = 0; i < 20000; ++i) {
        if (const auto workers = test::batchWorkers(); !workers.empty()) {
            return workers.front();
        }
        std::this_thread::sleep_for(1ms);
    }
    return -1;
}

TEST_F(CliBatch, ACaseThatHangsOrCrashesCostsItselfAlone)
{
    simulate(3);
    auto run = std::async(std::launch::async, [&] { return batch("out", {"--threads", "1", "--time-limit", "5"}); });
    const pid_t hanging = waitForWorker();
    ASSERT_GT(hanging, 0);
    kill(hanging, SIGSTOP);
    const auto outcome = run.get();
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_NE(summaryOf("out").find("1,\"c1\",\"c1/case.angiopose\",out of time,"), std::string::npos)
        << summaryOf("out");
    EXPECT_EQ(linesOf(in("out/summary.csv")), 4);
    EXPECT_TRUE(fs::exists(in("out/c3/result.json")));
    EXPECT_FALSE(fs::exists(in("out/c1/result.json")));

    auto second = std::async(std::launch::async, [&] { return batch("second", {"--threads", "1"}); });
    const pid_t crashing = waitForWorker();
    ASSERT_GT(crashing, 0);
    kill(crashing, SIGKILL);
    EXPECT_EQ(second.get().exitCode, 3);
    EXPECT_NE(summaryOf("second").find("1,\"c1\",\"c1/case.angiopose\",crashed,"), std::string::npos)
        << summaryOf("second");
    EXPECT_TRUE(fs::exists(in("second/c2/result.json")));

    // Both can be completed later.
    batch("out", {"--resume"});
    batch("second", {"--resume"});
    batch("quiet");
    EXPECT_EQ(summaryOf("out"), summaryOf("quiet"));
    EXPECT_EQ(summaryOf("second"), summaryOf("quiet"));
    EXPECT_EQ(test::lastingContentOf(in("out")), test::lastingContentOf(in("quiet")));
}

TEST_F(CliBatch, StopKeepsWhatIsFinished)
{
    simulate(2);
    std::string rows = "case,name\n";
    for (int i = 0; i < 60; ++i) {
        rows += "c" + std::to_string(1 + i % 2) + "/case.angiopose,r" + std::to_string(i) + "\n";
    }
    writeText(manifest_, rows);
    auto run = std::async(std::launch::async, [&] { return batch("out", {"--threads", "1"}); });
    const pid_t worker = waitForWorker();
    ASSERT_GT(worker, 0);
    for (int i = 0; i < 6000 && !fs::exists(in("out/r0/outcome.json")); ++i) {
        std::this_thread::sleep_for(10ms);
    }
    kill(test::parentOf(worker), SIGINT);
    const auto stopped = std::chrono::steady_clock::now();
    EXPECT_EQ(run.get().exitCode, 130);
    EXPECT_LT(std::chrono::steady_clock::now() - stopped, 10s);   // 2 s, with a margin for a busy machine
    std::ptrdiff_t kept = 0;
    for (const auto& entry : fs::directory_iterator(in("out"))) {
        kept += fs::exists(entry.path() / "outcome.json") ? 1 : 0;
    }
    EXPECT_GT(kept, 0);
    EXPECT_EQ(linesOf(in("out/summary.csv")), kept + 1);
}

}   // namespace
