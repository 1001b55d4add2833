#include "io/measurement_table.h"
#include "tests/io/case/small_case.h"
#include "tests/support/quoted_table.h"

using namespace angiopose;

namespace {

using test::contains;
using test::SmallCase;

nlohmann::json withMeasurements(const SmallCase& small)
{
    nlohmann::json json = small.json();
    json["measurements"] = nlohmann::json::parse(R"([
        { "kind": "length", "plane": "vessels", "pixels": [[1, 1], [11, 1]], "frame": 0, "name": "neck, \"a\"",
          "drawnBy": "A. B." },
        { "kind": "angle", "plane": "pixels", "pixels": [[10, 0], [0, 0], [0, 10]] },
        { "kind": "area", "plane": "detector", "pixels": [[0, 0], [4, 0], [4, 0.5]] } ])");
    return json;
}

TEST(CaseMeasurements, ComeBackAsTheyWere)
{
    SmallCase small;
    const auto loaded = small.load(withMeasurements(small));
    ASSERT_TRUE(loaded) << loaded.error().message;
    const auto& measured = loaded.value().shown().measurements;
    ASSERT_EQ(measured.size(), 3U);
    EXPECT_EQ(measured[1].kind, core::MeasurementKind::Angle);
    EXPECT_EQ(measured[1].plane, core::MeasurementPlane::Pixels);
    EXPECT_EQ(measured[2].pixels[2], Eigen::Vector2d(4, 0.5));

    core::Case more = loaded.value();
    more.shown().measurements[0].pixels[1] = {1.0 / 3.0, 0.1};
    more.shown().measurements[0].frame = 0;
    ASSERT_TRUE(io::saveCase(more, small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value().shown().measurements, more.shown().measurements);
    const auto saved = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    EXPECT_EQ(saved["measurements"][0]["drawnBy"], "A. B.");
}

TEST(CaseMeasurements, OfSlicesComeBackAndAreListed)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["vessel"]["measurements"] = nlohmann::json::parse(R"([
        { "kind": "length", "plane": "coronal", "pointsInPatientMm": [[0, 7, 0], [3, 7, 4]], "name": "neck",
          "drawnBy": "A. B." },
        { "kind": "area", "plane": "axial", "pointsInPatientMm": [[0, 0, 1], [4, 0, 1], [4, 0.5, 1]] } ])");
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_EQ(loaded.value().vessels.measurements.size(), 2U);
    EXPECT_EQ(loaded.value().vessels.measurements[0].plane, core::BodyPlane::Coronal);

    core::Case more = loaded.value();
    more.vessels.measurements[1].pointsInPatient[1] = {1.0 / 3.0, 0.1, 1.0};
    ASSERT_TRUE(io::saveCase(more, small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value().vessels.measurements, more.vessels.measurements);
    const auto saved = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    EXPECT_EQ(saved["vessel"]["measurements"][0]["drawnBy"], "A. B.");

    const std::string table = io::measurementTable(loaded.value());
    EXPECT_TRUE(contains(table, "\n,,length,neck,5,mm,coronal,,,,scan,")) << table;
    EXPECT_TRUE(contains(table, ",0 7 0;3 7 4\n")) << table;
    json["vessel"]["measurements"][1]["pointsInPatientMm"].erase(2);
    EXPECT_TRUE(contains(small.errorOf(json), "vessel.measurements: 1")) << small.errorOf(json);
}

TEST(CaseMeasurements, WhatIsNoneIsRefusedByItsKey)
{
    SmallCase small;
    nlohmann::json json = withMeasurements(small);
    json["measurements"][1]["pixels"].erase(2);
    EXPECT_TRUE(contains(small.errorOf(json), "measurements: 1")) << small.errorOf(json);
    json = withMeasurements(small);
    json["measurements"][0]["kind"] = "volume";
    EXPECT_NE(small.errorOf(json), "loaded");
    json = withMeasurements(small);
    json["measurements"][0].erase("pixels");
    EXPECT_NE(small.errorOf(json), "loaded");
}

TEST(CaseMeasurements, OfAnotherViewStayWithIt)
{
    SmallCase small;
    nlohmann::json json = small.json();
    nlohmann::json view{{"angiogram", json["angiogram"]}, {"geometry", json["geometry"]}, {"pose", json["pose"]}};
    view["measurements"] = withMeasurements(small)["measurements"];
    json["views"] = {view};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded.value().shown().measurements.empty());
    ASSERT_EQ(loaded.value().views.size(), 2U);
    EXPECT_EQ(loaded.value().views[1].measurements.size(), 3U);
    EXPECT_TRUE(contains(io::measurementTable(loaded.value()), "\n2,0,length,"));
}

TEST(MeasurementTable, TellsValueBasisAndWhatIsMissing)
{
    SmallCase small;
    auto loaded = small.load(withMeasurements(small));
    ASSERT_TRUE(loaded) << loaded.error().message;
    core::Case session = std::move(loaded).value();
    session.shown().cameraFromPatient.translation = {0.0, 0.0, 740.0};
    const test::QuotedTable table(io::measurementTable(session));
    const auto cell = [&](std::size_t row, const char* column) { return table.cell(row, column); };
    ASSERT_TRUE(table.isEven());
    ASSERT_EQ(table.rowCount(), 3U);
    EXPECT_EQ(cell(0, "name"), "neck, a");
    EXPECT_EQ(cell(0, "unit"), "mm");
    EXPECT_NEAR(std::stod(cell(0, "value")), 10.0 * 740.0 / 2000.0, 1e-9);
    EXPECT_NEAR(std::stod(cell(0, "depth_mm")), 740.0, 1e-9);
    EXPECT_EQ(cell(0, "geometry"), "user");
    EXPECT_EQ(cell(1, "unit"), "deg");
    EXPECT_NEAR(std::stod(cell(1, "value")), 90.0, 1e-9);
    EXPECT_EQ(cell(1, "mm_per_px_u"), "");
    EXPECT_EQ(cell(2, "value"), "") << "no spacing: no area at the detector";
    EXPECT_TRUE(contains(cell(2, "notes"), "pixel spacing"));
    EXPECT_EQ(cell(2, "points"), "0 0;4 0;4 0.5");
}

}   // namespace
