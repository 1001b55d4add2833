#include "io/target_point_table.h"
#include "tests/io/case/small_case.h"
#include "tests/support/quoted_table.h"

using namespace angiopose;

namespace {

using test::contains;
using test::SmallCase;

nlohmann::json withMarks(const SmallCase& small)
{
    nlohmann::json json = small.json();
    json["vessel"]["marks"] = nlohmann::json::parse(R"([
        { "id": 4, "kind": "check-point", "name": "fork, \"a\"", "pointInPatientMm": [1.5, 0, 0], "by": "A. B." },
        { "id": 2, "kind": "ostium-ring", "name": "左主干 😀", "pointInPatientMm": [0, 0, 0], "normal": [0, 0, 2],
          "radiusMm": 1.75 } ])");
    json["sightings"] = nlohmann::json::parse(R"([{ "mark": 4, "pixel": [3, 4], "frame": 0 }])");
    json["annotations"] = nlohmann::json::parse(R"([
        { "kind": "arrow", "pixels": [[1, 1], [5, 5]], "text": "hier", "frame": 0, "size": 3 },
        { "kind": "text", "pixels": [[2, 3]], "text": "Engstelle" } ])");
    json["angiogram"]["typedMmPerPx"] = 0.25;
    return json;
}

TEST(CaseMarks, ComeBackAsTheyWere)
{
    SmallCase small;
    const auto loaded = small.load(withMarks(small));
    ASSERT_TRUE(loaded) << loaded.error().message;
    core::Case session = loaded.value();
    ASSERT_EQ(session.vessels.marks.size(), 2U);
    EXPECT_EQ(session.vessels.marks[1].normal, Eigen::Vector3d::UnitZ()) << "directions become unit";
    EXPECT_EQ(session.shown().annotations.at(0).kind, core::AnnotationKind::Arrow);
    EXPECT_EQ(*session.shown().enteredMmPerPx, 0.25);
    session.vessels.marks[0].pointInPatient.x() = 1.0 / 3.0;
    ASSERT_TRUE(io::saveCase(session, small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value().vessels.marks, session.vessels.marks);
    EXPECT_EQ(again.value().shown().observations, session.shown().observations);
    EXPECT_EQ(again.value().shown().annotations, session.shown().annotations);
    const auto saved = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    EXPECT_EQ(saved["vessel"]["marks"][0]["by"], "A. B.");
    EXPECT_EQ(saved["annotations"][0]["size"], 3);
}

TEST(CaseMarks, CasesFromBeforeHaveNone)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded.value().vessels.marks.empty());
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    const std::string saved = test::readText(small.path("saved.angiopose"));
    for (const char* key : {"\"marks\"", "\"sightings\"", "\"annotations\"", "typedMmPerPx"}) {
        EXPECT_FALSE(contains(saved, key)) << key;
    }
}

TEST(CaseMarks, WhatIsNoneIsRefusedByItsKey)
{
    SmallCase small;
    const auto errorOf = [&](const auto& change) {
        nlohmann::json json = withMarks(small);
        change(json);
        return small.errorOf(json);
    };
    EXPECT_TRUE(contains(errorOf([](auto& json) { json["vessel"]["marks"][1]["id"] = 4; }), "vessel.marks: 4"));
    EXPECT_TRUE(contains(errorOf([](auto& json) { json["vessel"]["marks"][1].erase("radiusMm"); }), "vessel.marks: 2"));
    EXPECT_TRUE(contains(errorOf([](auto& json) { json["annotations"][0]["pixels"].erase(1); }), "annotations: 0"));
    EXPECT_NE(errorOf([](auto& json) { json["vessel"]["marks"][0]["kind"] = "cross"; }), "loaded");
    EXPECT_NE(errorOf([](auto& json) { json["sightings"][0].erase("mark"); }), "loaded");
}

TEST(CheckPointTable, TellsErrorsAndWhatIsMissing)
{
    SmallCase small;
    auto loaded = small.load(withMarks(small));
    ASSERT_TRUE(loaded) << loaded.error().message;
    core::Case session = std::move(loaded).value();
    session.shown().cameraFromPatient = {};
    session.shown().cameraFromPatient.translation = {0.0, 0.0, 740.0};
    const test::QuotedTable table(io::targetPointTable(session));
    const auto camera = core::cameraOf(session.shown()).value();
    const Eigen::Vector2d expected = *core::project(camera, {1.5, 0.0, 740.0});
    ASSERT_TRUE(table.isEven());
    ASSERT_EQ(table.rowCount(), 2U);
    EXPECT_EQ(table.cell(0, "kind"), "check-point");
    EXPECT_EQ(table.cell(0, "view"), "1");
    EXPECT_NEAR(std::stod(table.cell(0, "expected_u_px")), expected.x(), 1e-9);
    EXPECT_NEAR(std::stod(table.cell(0, "error_px")), (expected - Eigen::Vector2d(3, 4)).norm(), 1e-9);
    EXPECT_EQ(table.cell(0, "claimed_mm"), "");
    EXPECT_TRUE(contains(table.cell(0, "notes"), "no error is predicted"));
    EXPECT_EQ(table.cell(1, "kind"), "ostium-ring");
    EXPECT_EQ(table.cell(1, "radius_mm"), "1.75");

    const auto json = nlohmann::json::parse(io::targetPointJson(session));
    ASSERT_EQ(json.size(), 2U);
    EXPECT_NEAR(json[0]["views"][0]["errorPx"].get<double>(), std::stod(table.cell(0, "error_px")), 1e-9);
    session.shown().observations.clear();
    EXPECT_TRUE(contains(io::targetPointTable(session), "Not marked in this frame")) << io::targetPointTable(session);
}

}   // namespace
