#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::readText;
using test::runCli;
using test::writeText;
using Json = nlohmann::json;
using Cells = std::map<std::string, std::string>;

using Matrix = std::array<std::array<double, 4>, 4>;
using Point = std::array<double, 3>;

/// The rows of a plain table, with cells by column name.
std::vector<Cells> rowsOfTable(const std::string& path)
{
    std::istringstream text(readText(path));
    std::vector<std::string> names;
    std::vector<Cells> rows;
    for (std::string line; std::getline(text, line);) {
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');) {
            cells.push_back(cell);
        }
        if (names.empty()) {
            names = cells;
            continue;
        }
        Cells& row = rows.emplace_back();
        for (std::size_t k = 0; k < cells.size(); ++k) {
            row[names[k]] = cells[k];
        }
    }
    return rows;
}

Matrix matrixOf(const std::string& posePath)
{
    const Json root = Json::parse(readText(posePath));
    return (root.contains("pose") ? root.at("pose") : root).at("cameraFromPatient").get<Matrix>();
}

Point moved(const Matrix& pose, const Point& point)
{
    Point result{};
    for (std::size_t row = 0; row < 3; ++row) {
        result[row] = pose[row][0] * point[0] + pose[row][1] * point[1] + pose[row][2] * point[2] + pose[row][3];
    }
    return result;
}

double length(const Point& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

Point minus(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Distance of a point from the line through the origin and another point, by the cross product.
double distanceToLine(const Point& p, const Point& on)
{
    const Point cross{p[1] * on[2] - p[2] * on[1], p[2] * on[0] - p[0] * on[2], p[0] * on[1] - p[1] * on[0]};
    return length(cross) / length(on);
}

const std::vector<Point> landmarks{{10.0, -4.0, 22.5}, {-31.0, 14.0, 3.0}, {5.5, 40.0, -27.0}, {0.0, 0.0, 60.0}};

std::string landmarkTable()
{
    std::ostringstream text;
    text << "name,x,y,z\n";
    for (const Point& point : landmarks) {
        text << "L," << point[0] << "," << point[1] << "," << point[2] << "\n";
    }
    return text.str();
}

/// Fixture: two simulated cases, the first with a pose from another program, and their ground truth.
class CliEvaluateOwn : public ::testing::Test {
protected:
    void SetUp() override
    {
        for (const char* seed : {"3", "5"}) {
            ASSERT_EQ(runCli({"simulate", "--seed", seed, "--branches", "8", "--output", folder.file(seed)}).exitCode,
                      0);
        }
        writeText(folder.file("landmarks.csv"), landmarkTable());
        Json off = Json::parse(readText(folder.file("3/true-pose.json")));
        off["cameraFromPatient"][0][3] = off["cameraFromPatient"][0][3].get<double>() + 3.0;
        off["cameraFromPatient"][2][3] = off["cameraFromPatient"][2][3].get<double>() + 4.0;
        writeText(folder.file("elsewhere.json"), off.dump());
        writeText(folder.file("cases.csv"),
                  "case,reference,landmarks,patient,condition,pose.elsewhere\n"
                  "3/case.angiopose,3/true-pose.json,landmarks.csv,ann,lca,elsewhere.json\n"
                  "5/case.angiopose,5/true-pose.json,,bob,lca,\n");
    }

    std::string output(const std::string& name) const { return folder.file(name); }

    test::ProgramOutcome evaluate(const std::string& name, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"evaluate", "own", folder.file("cases.csv"), "--output", output(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }

    test::TemporaryFolder folder;
};

TEST_F(CliEvaluateOwn, JudgesAPoseFoundElsewhereByHandwrittenFormulas)
{
    const auto outcome = evaluate("out", {"--method", "iterative-pnp"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const Matrix found = matrixOf(folder.file("elsewhere.json"));
    const Matrix truth = matrixOf(folder.file("3/true-pose.json"));
    double mtre = 0.0;
    double mrpd = 0.0;
    for (const Point& landmark : landmarks) {
        mtre += length(minus(moved(found, landmark), moved(truth, landmark))) / 4.0;
        mrpd += distanceToLine(moved(truth, landmark), moved(found, landmark)) / 4.0;
    }
    EXPECT_NEAR(mtre, 5.0, 1e-9);
    int judged = 0;
    for (const Cells& row : rowsOfTable(output("out/runs.csv"))) {
        if (row.at("method") == "elsewhere") {
            ++judged;
            EXPECT_NEAR(std::stod(row.at("mtre_mm")), mtre, 1e-6);
            EXPECT_NEAR(std::stod(row.at("mrpd_mm")), mrpd, 1e-6);
            EXPECT_EQ(row.at("trustworthy"), "nan");
            EXPECT_EQ(row.at("condition"), "lca");
        }
    }
    EXPECT_EQ(judged, 1);
    for (const char* file : {"report.html", "tables.md", "own-lca.tex", "own-lca-cumulative-mrpd.svg"}) {
        EXPECT_TRUE(fs::exists(output(std::string("out/") + file))) << file;
    }
    EXPECT_NE(readText(output("out/report.html")).find("<svg"), std::string::npos);
}

TEST_F(CliEvaluateOwn, LandmarksMayBeFiducialsOfSlicer)
{
    std::ostringstream fcsv;
    fcsv << "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = "
            "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    for (const Point& point : landmarks) {
        fcsv << "1," << point[0] << "," << point[1] << "," << point[2] << ",0,0,0,1,1,1,0,L,,\n";
    }
    writeText(folder.file("landmarks.fcsv"), fcsv.str());
    const auto mtreOf = [&](const std::string& file) {
        writeText(
            folder.file("cases.csv"),
            "case,reference,landmarks,pose.elsewhere\n3/case.angiopose,3/true-pose.json," + file + ",elsewhere.json\n");
        EXPECT_EQ(evaluate("of-" + file, {"--method", "iterative-pnp"}).exitCode, 0);
        const auto rows = rowsOfTable(output("of-" + file + "/runs.csv"));
        return rows.size() < 2 ? std::string() : rows[1].at("mtre_mm");
    };
    EXPECT_EQ(mtreOf("landmarks.fcsv"), mtreOf("landmarks.csv"));
}

/// Points of a tree table, in its order.
std::vector<Point> treePoints(const std::string& vesselsPath, const std::string& tablePath)
{
    EXPECT_EQ(runCli({"convert", vesselsPath, tablePath}).exitCode, 0);
    std::vector<Point> points;
    for (const Cells& row : rowsOfTable(tablePath)) {
        points.push_back({std::stod(row.at("x")), std::stod(row.at("y")), std::stod(row.at("z"))});
    }
    return points;
}

TEST_F(CliEvaluateOwn, DeformedVesselsAreJudgedWhereTheyLay)
{
    ASSERT_EQ(runCli({"simulate", "--seed", "6", "--non-rigid", "2", "--output", folder.file("bent")}).exitCode, 0);
    writeText(folder.file("cases.csv"),
              "case,reference,bent,pose.truth\n"
              "bent/case.angiopose,bent/true-pose.json,bent/true-vessels.vtp,"
              "bent/true-pose.json\n");
    const auto outcome = evaluate("out", {"--method", "angiopose,iterative-pnp"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const auto straight = treePoints(folder.file("bent/tree.vtp"), folder.file("straight.csv"));
    const auto lay = treePoints(folder.file("bent/true-vessels.vtp"), folder.file("lay.csv"));
    ASSERT_EQ(straight.size(), lay.size());
    const Matrix truth = matrixOf(folder.file("bent/true-pose.json"));
    double mtre = 0.0;
    double mrpd = 0.0;
    for (std::size_t i = 0; i < lay.size(); ++i) {
        mtre += length(minus(moved(truth, straight[i]), moved(truth, lay[i]))) / static_cast<double>(lay.size());
        mrpd += distanceToLine(moved(truth, lay[i]), moved(truth, straight[i])) / static_cast<double>(lay.size());
    }
    std::map<std::string, Cells> rows;
    for (const Cells& row : rowsOfTable(output("out/runs.csv"))) {
        rows[row.at("method")] = row;
    }
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(std::stod(rows["truth"].at("mtre_mm")), mtre, 1e-4);   // the table has five digits
    EXPECT_NEAR(std::stod(rows["truth"].at("mrpd_mm")), mrpd, 1e-4);
    EXPECT_GT(mrpd, 0.5);   // the best rigid pose cannot be better
    EXPECT_LT(std::stod(rows["angiopose"].at("mrpd_mm")), 0.6 * mrpd);
}

TEST_F(CliEvaluateOwn, DeformedVesselsOfAnotherTreeAreToldAndNotJudged)
{
    writeText(folder.file("cases.csv"), "case,reference,bent\n3/case.angiopose,3/true-pose.json,5/tree.vtp\n");
    const auto outcome = evaluate("out", {"--method", "iterative-pnp"});
    EXPECT_NE(outcome.messages.find("5/tree.vtp"), std::string::npos) << outcome.messages;
    const auto rows = rowsOfTable(output("out/runs.csv"));
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].at("has_result"), "0");
}

TEST_F(CliEvaluateOwn, AnswersAsRegisterDoesForEachCase)
{
    ASSERT_EQ(evaluate("out").exitCode, 0);
    const auto registered = runCli({"register", folder.file("3/case.angiopose"), "--output", output("registered")});
    ASSERT_TRUE(registered.exitCode == 0 || registered.exitCode == 4) << registered.messages;
    const Matrix found = matrixOf(output("registered/result.json"));
    const Matrix truth = matrixOf(folder.file("3/true-pose.json"));
    double mtre = 0.0;
    for (const Point& landmark : landmarks) {
        mtre += length(minus(moved(found, landmark), moved(truth, landmark))) / 4.0;
    }
    for (const Cells& row : rowsOfTable(output("out/runs.csv"))) {
        if (row.at("method") == "case" && row.at("trial") == "0") {
            EXPECT_NEAR(std::stod(row.at("mtre_mm")), mtre, 1e-6);
        }
    }
}

TEST_F(CliEvaluateOwn, ShardsAndThreadsChangeNoByte)
{
    ASSERT_EQ(evaluate("whole", {"--method", "iterative-pnp,dt-icp", "--threads", "2"}).exitCode, 0);
    ASSERT_EQ(evaluate("a", {"--method", "iterative-pnp,dt-icp", "--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(evaluate("b", {"--method", "iterative-pnp,dt-icp", "--shard", "2/2"}).exitCode, 0);
    const auto merged = runCli({"evaluate", "own", "--merge", output("b"), output("a"), "--output", output("merged")});
    ASSERT_EQ(merged.exitCode, 0) << merged.messages;
    EXPECT_EQ(readText(output("merged/runs.csv")), readText(output("whole/runs.csv")));
    EXPECT_EQ(readText(output("merged/own-lca.tex")), readText(output("whole/own-lca.tex")));
}

TEST_F(CliEvaluateOwn, PairsOfPointsJudgeWithoutAReference)
{
    const auto described = runCli({"info", "--json", folder.file("3/case.angiopose")});
    ASSERT_EQ(described.exitCode, 0) << described.messages;
    const Json camera = Json::parse(described.output).at("camera");
    const double fx = camera.at("fx");
    const double fy = camera.at("fy");
    const Point at = moved(matrixOf(folder.file("3/true-pose.json")), landmarks.front());
    const double u = fx * at[0] / at[2] + camera.at("cx").get<double>();
    const double v = fy * at[1] / at[2] + camera.at("cy").get<double>();
    std::ostringstream pairs;
    pairs.precision(17);
    pairs << "x,y,z,u,v\n10,-4,22.5," << u + 3.0 << "," << v + 4.0 << "\n";
    writeText(folder.file("pairs.csv"), pairs.str());
    writeText(folder.file("cases.csv"), "case,pairs,pose.truth\n3/case.angiopose,pairs.csv,3/true-pose.json\n");
    const auto outcome = evaluate("pairs", {"--method", "iterative-pnp"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const Point ray{at[0] + 3.0 / fx * at[2], at[1] + 4.0 / fy * at[2], at[2]};
    int judged = 0;
    for (const Cells& row : rowsOfTable(output("pairs/runs.csv"))) {
        if (row.at("method") == "truth") {
            ++judged;
            EXPECT_EQ(row.at("mtre_mm"), "nan");
            EXPECT_NEAR(std::stod(row.at("mean_px")), 5.0, 1e-9);
            EXPECT_NEAR(std::stod(row.at("mrpd_mm")), distanceToLine(at, ray), 1e-6);
        }
    }
    EXPECT_EQ(judged, 1);
}

TEST_F(CliEvaluateOwn, ACaseThatCannotBeOpenedIsToldAndCounted)
{
    writeText(folder.file("cases.csv"),
              "case,reference\nnowhere.angiopose,3/true-pose.json\n5/case.angiopose,5/true-pose.json\n");
    const auto outcome = evaluate("out", {"--method", "iterative-pnp"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.messages.find("line 2"), std::string::npos) << outcome.messages;
    const auto rows = rowsOfTable(output("out/runs.csv"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].at("has_result"), "0");
    EXPECT_EQ(rows[1].at("has_result"), "1");
}

TEST_F(CliEvaluateOwn, WrongListsAreRefusedWithTheLine)
{
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"case\n3/case.angiopose\n", "reference"},
        {"case,reference\n,3/true-pose.json\n", "line 2"},
        {"case,reference\n3/case.angiopose,\n", "line 2"},
        {"case,reference,condition\n3/case.angiopose,3/true-pose.json,a/b\n", "a/b"},
        {"case,reference\n3/case.angiopose,nowhere.json\n", "nowhere.json"},
        {"case,reference,bent\n3/case.angiopose,3/true-pose.json,nowhere.vtp\n", "nowhere.vtp"},
        {"case,reference,bent,landmarks\n3/case.angiopose,3/true-pose.json,3/tree.vtp,landmarks.csv\n", "line 2"},
        {"case,reference,landmarks\n3/case.angiopose,3/true-pose.json,cases.csv\n", "column x"}};
    for (const auto& [text, word] : wrong) {
        writeText(folder.file("cases.csv"), text);
        const auto outcome = evaluate("out");
        EXPECT_EQ(outcome.exitCode, 3) << text;
        EXPECT_NE(outcome.messages.find(word), std::string::npos) << outcome.messages;
    }
    EXPECT_EQ(runCli({"evaluate", "own", "--output", output("out")}).exitCode, 2);
    EXPECT_EQ(runCli({"evaluate", "toy", folder.file("cases.csv"), "--output", output("out")}).exitCode, 2);
    EXPECT_FALSE(fs::exists(output("out")));
}

}   // namespace
