#include "core/evaluation/run_experiment.h"

#include "core/evaluation/report/result_table.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;

ExperimentPlan smallPlan(std::string_view protocol, const std::string& conditions, std::uint64_t trials)
{
    ExperimentPlan plan;
    plan.protocol = findProtocol(protocol);
    plan.conditions = parseConditions(*plan.protocol, conditions).value();
    plan.evaluatedMethods = parseMethods("dynaweight,iterative-pnp").value();
    plan.trials = trials;
    plan.seed = 3;
    return plan;
}

/// Expects the same runs to the last bit, except for times.
void expectSameRuns(const RunSet& a, const RunSet& b)
{
    ASSERT_EQ(a.runs.size(), b.runs.size());
    for (std::size_t k = 0; k < a.runs.size(); ++k) {
        EXPECT_EQ(a.runs[k].condition, b.runs[k].condition);
        EXPECT_EQ(a.runs[k].method, b.runs[k].method);
        EXPECT_EQ(a.runs[k].trial, b.runs[k].trial);
        EXPECT_EQ(a.runs[k].anatomy, b.runs[k].anatomy);
        EXPECT_EQ(a.runs[k].history, b.runs[k].history);
        for (const RunField& field : runFields()) {
            const double x = a.runs[k].*field.value;
            const double y = b.runs[k].*field.value;
            EXPECT_TRUE(field.isTime || x == y || (x != x && y != y)) << field.name << " " << x << " " << y;
        }
    }
}

TEST(RunExperiment, GivesTheSameBitsForAnyNumberOfThreads)
{
    ExperimentPlan plan = smallPlan("toy", "b1-44,b2-8", 4);
    const Experiment alone = runExperiment(plan);
    plan.threads = 4;
    const Experiment together = runExperiment(plan);
    EXPECT_EQ(alone.runs.runs.size(), 16u);
    EXPECT_FALSE(alone.wasStopped);
    expectSameRuns(alone.runs, together.runs);
}

TEST(RunExperiment, MergedShardsAreTheWholeToTheLastBit)
{
    ExperimentPlan plan = smallPlan("toy", "b1-44,b2-8", 4);
    const Experiment whole = runExperiment(plan);
    std::vector<RunSet> parts;
    for (const std::uint64_t index : {2u, 0u, 1u}) {
        plan.shard = {index, 3};
        parts.push_back(runExperiment(plan).runs);
    }
    const auto together = mergeRunSets(parts);
    ASSERT_TRUE(together) << together.error().message;
    expectSameRuns(whole.runs, together.value());
    parts.push_back(parts.front());   // duplicate parts change nothing
    expectSameRuns(whole.runs, mergeRunSets(parts).value());
}

TEST(RunExperiment, MergingRefusesWhatDoesNotBelongTogether)
{
    RunSet runs = runExperiment(smallPlan("toy", "b1-8", 1)).runs;
    EXPECT_FALSE(mergeRunSets({}));
    RunSet otherSeed = runs;
    otherSeed.seed = 4;
    EXPECT_FALSE(mergeRunSets({runs, otherSeed}));
    RunSet otherFigure = runs;
    otherFigure.runs.front().meanPx += 1.0;
    const auto disagreeing = mergeRunSets({runs, otherFigure});
    ASSERT_FALSE(disagreeing);
    EXPECT_NE(disagreeing.error().message.text().find("dynaweight"), std::string::npos);
    RunSet otherCondition = runs;
    otherCondition.runs.front().condition = "magic";
    EXPECT_FALSE(mergeRunSets({otherCondition}));
}

TEST(RunExperiment, StopsAndKeepsFinishedTrials)
{
    ExperimentPlan plan = smallPlan("toy", "b1-44", 50);
    plan.threads = 2;
    const Experiment stopped = runExperiment(plan, [](std::uint64_t done, std::uint64_t) {
        return done < 3 ? ObserverDecision::Continue : ObserverDecision::Stop;
    });
    EXPECT_TRUE(stopped.wasStopped);
    EXPECT_GE(stopped.runs.runs.size(), 6u);
    EXPECT_LT(stopped.runs.runs.size(), 50u);
    for (std::size_t k = 0; k < stopped.runs.runs.size(); k += 2) {
        EXPECT_EQ(stopped.runs.runs[k].trial, stopped.runs.runs[k + 1].trial);   // both methods or neither
    }
}

TEST(RunExperiment, CountsAnUnusableTrialAsAFailureAtTheStart)
{
    Protocol empty = *findProtocol("toy");
    empty.prepare = [](std::size_t condition, std::uint64_t seed) -> TrialMaker {
        return [maker = findProtocol("toy")->prepare(condition, seed)](std::uint64_t number) {
            Trial trial = maker(number);
            trial.input.target = {};   // as after a failed tracing
            return trial;
        };
    };
    ExperimentPlan plan = smallPlan("toy", "b1-44", 1);
    plan.protocol = &empty;
    const RunSet runs = runExperiment(plan).runs;
    ASSERT_EQ(runs.runs.size(), 2u);
    EXPECT_EQ(runs.runs.front().hasResult, 0.0);
    EXPECT_EQ(runs.runs.front().trustworthy, 0.0);
    EXPECT_EQ(runs.runs.front().meanPx, runs.runs.front().startMeanPx);
}

// The printed square does not determine a pose: whichever method matches it to its line, the pose is unreliable.
TEST(TablesOf, TheSquareAsPrintedIsDoubtedInEveryRun)
{
    ExperimentPlan plan = smallPlan("toy", "a-44,a-84", 3);
    plan.evaluatedMethods = parseMethods("angiopose,iterative-pnp").value();
    const std::vector<ResultTable> tables = makeTables(runExperiment(plan).runs);
    const auto doubted = std::ranges::find(tables, "toy-a-doubted", &ResultTable::id);
    ASSERT_NE(doubted, tables.end());
    ASSERT_EQ(doubted->rows.size(), 2u);
    for (const ResultTable::Row& row : doubted->rows) {
        EXPECT_EQ(row.cells[1], "3 of 3") << row.cells[0];
        EXPECT_EQ(row.cells[2], "3 of 3") << row.cells[0];
    }
    EXPECT_TRUE(std::ranges::none_of(tables, [](const ResultTable& table) { return table.id == "toy-a-failures"; }));
}

TEST(TablesOf, EveryRowHasACellPerColumn)
{
    for (const auto& [protocol, condition] : {std::pair<std::string_view, std::string>{"toy", "b1"},
                                              {"simulation", "obj-2-5"},
                                              {"robustness", "full-5-2"},
                                              {"capture-range", "clean-0-1,clean-1-2"}}) {
        const RunSet runs = runExperiment(smallPlan(protocol, condition, 1)).runs;
        for (const ResultTable& table : makeTables(runs)) {
            EXPECT_FALSE(table.rows.empty()) << table.id;
            EXPECT_FALSE(table.notes.empty()) << table.id;
            for (const ResultTable::Row& row : table.rows) {
                EXPECT_EQ(row.cells.size(), table.columns.size()) << table.id;
            }
        }
    }
}

RunRecord runWith(const std::string& method, std::uint64_t trial, double meanMm)
{
    RunRecord run;
    run.condition = "exact-cam-2-5";
    run.method = method;
    run.trial = trial;
    run.anatomy = static_cast<int>(trial % 10);
    run.hasResult = 1.0;
    run.trustworthy = 1.0;
    run.meanMm = meanMm;
    run.meanPx = meanMm / 0.426;
    return run;
}

TEST(TablesOf, CountsFailuresAndSetsThePublishedRowInATableOfItsOwn)
{
    RunSet runs{"simulation", 1, {}};
    for (std::uint64_t trial = 0; trial < 10; ++trial) {
        runs.runs.push_back(runWith("angiopose", trial, 0.1));
        runs.runs.push_back(runWith("dynaweight:seed_mean", trial, trial < 2 ? 4.0 : 0.25));
    }
    const std::vector<ResultTable> tables = makeTables(runs);
    const ResultTable& errors = tables.front();
    ASSERT_EQ(errors.rows.size(), 2u);
    EXPECT_TRUE(errors.rows[0].cells[1].starts_with("0.0 ["));
    EXPECT_TRUE(errors.rows[1].cells[1].starts_with("20.0 ["));
    EXPECT_EQ(errors.rows[1].cells[3], "0.250");
    const ResultTable& published = tables[1];
    ASSERT_EQ(published.rows.size(), 2u);
    EXPECT_TRUE(published.rows[1].isPublished);
    EXPECT_EQ(published.rows[1].cells[2], "0.24");
    const ResultTable& statistics = tables[2];
    ASSERT_EQ(statistics.rows.size(), 2u);   // medians and 95th percentiles
    EXPECT_EQ(statistics.rows[0].cells[2], "median");
    EXPECT_EQ(statistics.rows[0].cells[3], "10");   // one pair per tree
    EXPECT_EQ(statistics.rows[0].cells[5], "9.8e-04");   // 1/1024
    EXPECT_EQ(statistics.rows[1].cells[2], "p95");
}

ResultTable tableOf(const std::vector<ResultTable>& tables, const std::string& id)
{
    return *std::find_if(tables.begin(), tables.end(), [&](const ResultTable& table) { return table.id == id; });
}

TEST(TablesOf, SayWhichBinsOfTheCaptureRangeWereNotRun)
{
    RunSet runs{"capture-range", 1, {}};
    for (const std::string condition : {"degraded-0-1", "degraded-1-2", "degraded-3-4"}) {
        for (std::uint64_t trial = 0; trial < 20; ++trial) {
            RunRecord run = runWith("angiopose", trial, 0.1);
            run.condition = condition;
            run.mrpdMm = 0.2;
            runs.runs.push_back(run);
        }
    }
    const ResultTable table = tableOf(makeTables(runs), "capture-range-degraded");
    EXPECT_EQ(table.rows[0].cells[1], "≥ 2");   // 3–4 succeeds, but the range below it was not run
    EXPECT_EQ(table.rows.size(), 4u);
    EXPECT_TRUE(table.notes.back().starts_with("Not run: 2-3, 4-5")) << table.notes.back();
}

TEST(TablesOf, CountsWhichMethodsStandInThePublishedOrder)
{
    RunSet runs{"clinical", 1, {}};
    // Published medians: nicp 3.49, dynaweight 4.02, dt-icp 4.84 mm.
    for (const auto& [method, meanMm] :
         {std::pair<std::string, double>{"nicp", 1.0}, {"dynaweight", 3.0}, {"dt-icp", 2.0}}) {
        RunRecord run = runWith(method, 0, meanMm);
        run.condition = "nonrigid-1";
        run.nees = 1e6;
        run.mrpdMm = meanMm;
        runs.runs.push_back(run);
    }
    const ResultTable table = tableOf(makeTables(runs), "clinical-nonrigid-1");
    EXPECT_NE(table.notes.back().find("2 of 3 pairs"), std::string::npos) << table.notes.back();
    const auto nees = std::find(table.columns.begin(), table.columns.end(), "NEES") - table.columns.begin();
    EXPECT_EQ(table.rows[2].cells[static_cast<std::size_t>(nees)], table.rows[0].cells[static_cast<std::size_t>(nees)]);
    EXPECT_NE(table.rows[2].cells[static_cast<std::size_t>(nees)], "–");   // also for failures
}

TEST(TablesOf, LaysOutTheAblation)
{
    RunSet runs{"simulation", 1, {}};
    const std::vector<EvaluatedMethod> ablation = parseMethods("ablation").value();
    for (const EvaluatedMethod& evaluatedMethod : ablation) {
        const bool isBoth = evaluatedMethod.options.seed.rotationFirst && evaluatedMethod.options.seed.alternation;
        runs.runs.push_back(runWith(evaluatedMethod.label, 0, isBoth ? 0.1 : 9.0));
    }
    for (const ResultTable& table : makeTables(runs)) {
        if (table.id.ends_with("-ablation")) {
            ASSERT_EQ(table.rows.size(), 4u);
            for (const ResultTable::Row& row : table.rows) {
                EXPECT_TRUE(row.cells[1].starts_with("100.0"));
                EXPECT_TRUE(row.cells[4].starts_with("0.0"));
            }
            return;
        }
    }
    FAIL() << "no ablation table";
}

}   // namespace
