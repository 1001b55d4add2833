#include "io/snapshot_table.h"

#include "io/evaluation/observer_readings.h"
#include "io/observer_log.h"
#include "io/support/csv_table.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <fstream>
#include <sstream>

using namespace angiopose;

namespace {

core::PoseSnapshot snapshotAt(const std::string& name, double right)
{
    core::PoseSnapshot snapshot;
    snapshot.name = name;
    snapshot.cameraFromPatient.translation = {right, 0.0, 700.0};
    return snapshot;
}

std::string readText(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

TEST(SnapshotTable, TellsEveryPoseAndItsDistanceFromTheReference)
{
    core::PoseSnapshot measured = snapshotAt("b", 3.0);
    measured.metrics = core::SnapshotMetrics{0.7, 0.25, 0.6, 0.93, true};
    measured.runMs = 12.5;
    measured.method = "angiopose";
    const std::vector snapshots{snapshotAt("a", 0.0), measured};

    const std::string text = io::snapshotTable(snapshots, snapshots[0], {1.0, 2.0, 3.0});
    const auto table = io::parseCsv(text, "poses.csv");

    ASSERT_TRUE(table) << table.error().message;
    ASSERT_EQ(table.value().rows.size(), 2u);
    const auto number = [&](std::size_t row, const char* column) {
        return io::numberInCell(table.value(), row, *table.value().column(column)).value();
    };
    EXPECT_EQ(number(0, "in_plane_difference_mm"), 0.0);
    EXPECT_EQ(number(1, "in_plane_difference_mm"), 3.0);
    EXPECT_EQ(number(1, "median_mm"), 0.25);
    EXPECT_EQ(number(1, "run_ms"), 12.5);
    EXPECT_EQ(number(1, "t0"), 3.0);
    EXPECT_EQ(number(1, "t2"), 700.0);
    EXPECT_EQ(number(1, "r00"), 1.0);
    EXPECT_EQ(table.value().rows[0][*table.value().column("median_mm")], "");
}

TEST(SnapshotTable, QuotesTextsThatHoldCommasQuotesAndLines)
{
    EXPECT_EQ(io::csvCell("plain"), "plain");
    EXPECT_EQ(io::csvCell("a, b"), "\"a, b\"");
    EXPECT_EQ(io::csvCell("say \"hi\""), "\"say \"\"hi\"\"\"");
    EXPECT_EQ(io::csvCell("two\nlines"), "\"two\nlines\"");
}

io::ObserverTrial trialOf(const std::string& observer)
{
    io::ObserverTrial trial;
    trial.observer = observer;
    trial.startedAt = "2026-11-21T16:00:00Z";
    trial.seed = 7;
    trial.durationS = 42.5;
    trial.editCount = 31;
    trial.finalPose.translation = {0.0, 4.0, 3.0};
    return trial;
}

TEST(ObserverLog, AddsOneRowPerTrialToWhatIsThere)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("trials.csv");
    ASSERT_TRUE(io::appendTrial(trialOf("Ada"), path));
    io::ObserverTrial abandoned = trialOf("Bob");
    abandoned.isAbandoned = true;
    ASSERT_TRUE(io::appendTrial(abandoned, path));

    const std::string text = readText(path);
    const auto table = io::parseCsv(text, path);
    ASSERT_TRUE(table) << table.error().message;
    ASSERT_EQ(table.value().rows.size(), 2u);
    const auto cell = [&](std::size_t row, const char* column) {
        return std::string(table.value().rows[row][*table.value().column(column)]);
    };
    EXPECT_EQ(cell(0, "observer"), "Ada");
    EXPECT_EQ(cell(0, "outcome"), "done");
    EXPECT_EQ(cell(1, "outcome"), "abandoned");
    EXPECT_EQ(cell(0, "duration_s"), "42.5");
    EXPECT_EQ(cell(0, "edits"), "31");
    EXPECT_EQ(cell(0, "in_plane_from_centre_mm"), "4");
    EXPECT_EQ(cell(0, "depth_from_centre_mm"), "3");
    EXPECT_EQ(cell(0, "final_t1"), "4");
}

TEST(ObserverLog, IsReadBackAsReadingsWithoutWhatWasAbandoned)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("trials.csv");
    io::ObserverTrial trial = trialOf("Ada");
    trial.caseTitle = "Phantom, view \"IM3\", left";
    trial.pivotInPatient = {1.5, -2.25, 3.0};
    trial.centerPose.translation = {0.0, 0.0, 700.5};
    trial.finalPose.rotation = core::expSo3({0.1, 0.2, 0.3});
    ASSERT_TRUE(io::appendTrial(trial, path));
    io::ObserverTrial abandoned = trial;
    abandoned.isAbandoned = true;
    ASSERT_TRUE(io::appendTrial(abandoned, path));
    const auto readings = io::readObserverReadings(path);
    ASSERT_TRUE(readings) << readings.error().message;
    ASSERT_EQ(readings.value().size(), 1u);
    const core::ObserverReading& reading = readings.value().front();
    EXPECT_EQ(reading.observer, "Ada");
    EXPECT_EQ(reading.pivotInPatient, trial.pivotInPatient);
    EXPECT_EQ(reading.cameraFromPatient.rotation, trial.finalPose.rotation);
    EXPECT_EQ(reading.referenceCameraFromPatient.translation, trial.centerPose.translation);
}

TEST(ObserverLog, OfAnEarlierVersionGoesOnAsItIsAndSaysWhatItLacks)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("trials.csv");
    ASSERT_TRUE(io::appendTrial(trialOf("Ada"), path));
    std::string older = readText(path);
    older.resize(older.find('\n'));
    older.resize(older.find(",pivot_x"));
    std::ofstream(path) << older << '\n';
    ASSERT_TRUE(io::appendTrial(trialOf("Bob"), path));
    const auto table = io::parseCsv(older = readText(path), path);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table.value().rows.size(), 1u);
    const auto readings = io::readObserverReadings(path);
    ASSERT_FALSE(readings);
    EXPECT_NE(readings.error().message.text().find("pivot_x"), std::string::npos);
}

TEST(ObserverLog, DoesNotTouchAnotherFile)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("letters.csv");
    std::ofstream(path) << "dear diary\n";
    const auto refused = io::appendTrial(trialOf("Ada"), path);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.text().find("not a blind trial log"), std::string::npos);
    EXPECT_EQ(readText(path), "dear diary\n");
}

}   // namespace
