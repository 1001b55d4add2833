#include "core/evaluation/report/table_parts.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;

/// Adds a hundred runs, of which `lost` end 8 px from the nearest vessels and the others `goodPx`.
void addRuns(const std::string& method, int lost, double goodPx, RunSet& runs)
{
    for (int i = 0; i < 100; ++i) {
        RunRecord run;
        run.condition = "exact-cam-norm-2-5";
        run.method = method;
        run.trial = static_cast<std::uint64_t>(i);
        run.closestMeanPx = i < lost ? 8.0 : goodPx;
        run.meanPx = i < lost ? 60.0 : goodPx;   // distance to the true correspondences
        run.meanMm = 0.4 * run.meanPx;
        run.startMeanPx = 50.0;
        runs.runs.push_back(run);
    }
}

const ResultTable& published(const std::vector<ResultTable>& tables)
{
    return *std::find_if(tables.begin(), tables.end(), [](const ResultTable& table) {
        return table.id == "simulation-exact-cam-norm-2-5-published";
    });
}

TEST(AsPublishedTables, CompareWhatThePaperMeasures)
{
    RunSet runs{"simulation", 1, {}};
    addRuns("angiopose", 0, 0.001, runs);   // not in the paper
    addRuns("dt-icp", 54, 0.5, runs);
    addRuns("iterative-pnp", 30, 0.5, runs);   // published: 4 %
    addRuns("nicp", 8, 0.5, runs);
    const std::vector<ResultTable> tables = asPublishedTables(RunGroups(runs));
    ASSERT_EQ(tables.size(), 1u);
    const ResultTable& table = published(tables);
    ASSERT_EQ(table.rows.size(), 6u);
    EXPECT_EQ(table.rows[0].cells[0], "dt-icp");
    EXPECT_EQ(table.rows[0].cells[1].substr(0, 4), "54.0");
    EXPECT_EQ(table.rows[0].cells[2], "1.82");   // 0.4 mm/px × (54 × 8 + 46 × 0.5) px / 100
    // Published 1.80, and 3.49 and 6.65 for the 75th and 95th percentiles; here both percentiles are 3.2.
    EXPECT_EQ(table.rows[0].cells.back(), "no: p95");
    EXPECT_TRUE(table.rows[1].isPublished);
    EXPECT_EQ(table.rows[2].cells.back(), "no: GFR, mean, p75, p95");
    EXPECT_EQ(table.rows[4].cells[1].substr(0, 3), "8.0");
    EXPECT_EQ(table.rows[4].cells.back(), "no: p75");   // a result much better than published is no reproduction either
}

TEST(AsPublishedTables, SayWhyOfEveryMethodTheyShow)
{
    RunSet runs{"simulation", 1, {}};
    const std::vector<std::string> methods{
        "dynaweight:seed_mean", "iterative-pnp", "nicp", "dt-icp", "automask", "rgbr"};
    for (const std::string& method : methods) {
        addRuns(method, 3, 0.5, runs);
    }
    const std::vector<ResultTable> tables = asPublishedTables(RunGroups(runs));
    const ResultTable& table = published(tables);
    for (const std::string& method : methods) {
        EXPECT_TRUE(std::any_of(table.notes.begin(), table.notes.end(), [&](const std::string& note) {
            return note.starts_with(methodIdOf(method) + ": ");
        })) << method;
    }
}

TEST(AsPublishedTables, StayAwayFromOtherStarts)
{
    RunSet runs{"simulation", 1, {}};
    addRuns("dt-icp", 54, 0.5, runs);
    for (RunRecord& run : runs.runs) {
        run.condition = "obj-2-5";
    }
    EXPECT_TRUE(asPublishedTables(RunGroups(runs)).empty());
}

}   // namespace
