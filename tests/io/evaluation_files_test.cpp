#include "io/evaluation/run_files.h"
#include "io/evaluation/table_text.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

RunSet twoRuns()
{
    RunSet runs{"toy", 18446744073709551615ULL, {}};
    RunRecord run;
    run.condition = "b1-8";
    run.method = "dynaweight:seed_mean:rotationFirst=off";
    run.trial = 12345678901ULL;
    run.meanPx = 0.1 + 0.2;   // has no short decimal form
    run.meanMm = std::numeric_limits<double>::infinity();
    run.p95Px = -std::numeric_limits<double>::quiet_NaN();
    run.totalMs = 1.5;
    run.history = {3.0, 1.0 / 3.0};
    runs.runs.push_back(run);
    run.method = "angiopose";
    run.history.clear();
    runs.runs.push_back(run);
    return runs;
}

TEST(RunFiles, ComeBackAsTheyWere)
{
    const test::TemporaryFolder folder;
    const RunSet runs = twoRuns();
    ASSERT_TRUE(io::writeRuns(runs, folder.file("")));
    const auto read = io::readRuns(folder.file(""));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().protocol, runs.protocol);
    EXPECT_EQ(read.value().seed, runs.seed);
    ASSERT_EQ(read.value().runs.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(read.value().runs[k].method, runs.runs[k].method);
        EXPECT_EQ(read.value().runs[k].trial, runs.runs[k].trial);
        EXPECT_EQ(read.value().runs[k].history, runs.runs[k].history);
        for (const RunField& field : runFields()) {
            const double written = runs.runs[k].*field.value;
            const double found = read.value().runs[k].*field.value;
            EXPECT_TRUE(written == found || (written != written && found != found)) << field.name;
        }
    }
    const std::string text = test::readText(folder.file("runs.csv"));
    EXPECT_EQ(text.find("-nan"), std::string::npos);
    EXPECT_EQ(text.find("_ms"), std::string::npos);   // times vary between runs and are stored elsewhere
}

TEST(RunFiles, BrokenOnesAreRefusedByName)
{
    const test::TemporaryFolder folder;
    EXPECT_FALSE(io::readRuns(folder.file("nowhere")));
    ASSERT_TRUE(io::writeRuns(twoRuns(), folder.file("")));
    const std::string good = test::readText(folder.file("runs.csv"));
    std::string noNumber = good;
    noNumber.replace(noNumber.find("0.30000000000000004"), 3, "abc");
    std::string twoSeeds = good;
    twoSeeds.replace(twoSeeds.rfind("18446744073709551615"), 20, "7");
    for (const std::string& text : {std::string("a,b\n1,2\n"), noNumber, twoSeeds}) {
        test::writeText(folder.file("runs.csv"), text);
        const auto read = io::readRuns(folder.file(""));
        ASSERT_FALSE(read);
        EXPECT_NE(read.error().message.text().find("runs.csv"), std::string::npos) << read.error().message;
    }
}

ResultTable awkwardTable()
{
    ResultTable table{"awkward", "50 % of A & B_1 | 2°", {"method", "GFR %", "p < 0.05"}, {}, {"r = Φ⁻¹(1 − p)/√N."}};
    table.rows.push_back({{"dyna_weight:a", "1.0 [0.5, 2.0]", "–"}, false});
    table.rows.push_back({{"dyna, published", "1", "–"}, true});
    return table;
}

TEST(MarkdownTable, EveryLineHasAsManyCells)
{
    const std::string text = io::toMarkdown(awkwardTable());
    EXPECT_NE(text.find("### 50 % of A & B\\_1 \\| 2°\n"), std::string::npos) << text;
    EXPECT_NE(text.find("|---|---:|---:|\n"), std::string::npos);
    EXPECT_NE(text.find("| *dyna, published* | *1* | *–* |"), std::string::npos) << text;
    for (std::size_t from = text.find("\n|"); from != std::string::npos; from = text.find("\n|", from + 1)) {
        const std::string line = text.substr(from + 1, text.find('\n', from + 1) - from - 1);
        EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 4) << line;
    }
}

TEST(LatexTable, EscapesWhatLatexWouldObeyAndKeepsAscii)
{
    const std::string text = io::toLatex(awkwardTable());
    EXPECT_NE(text.find("50 \\% of A \\& B\\_1"), std::string::npos) << text;
    EXPECT_NE(text.find("dyna\\_weight:a & 1.0 [0.5, 2.0] & -- \\\\"), std::string::npos) << text;
    EXPECT_NE(text.find("\\textit{dyna, published} & \\textit{1}"), std::string::npos) << text;
    EXPECT_NE(text.find("$\\Phi^{-1}$"), std::string::npos);
    EXPECT_NE(text.find("{lrr}"), std::string::npos);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; }))
        << text;
    const auto count = [&](char c) { return std::count(text.begin(), text.end(), c); };
    EXPECT_EQ(count('{'), count('}'));
    EXPECT_EQ(count('$') % 2, 0);
}

TEST(PlainTable, AlignsColumnsByWhatIsShown)
{
    const std::string text = io::toPlainText(awkwardTable());
    EXPECT_NE(text.find("dyna_weight:a    1.0 [0.5, 2.0]         –\n"), std::string::npos) << text;
}

}   // namespace
