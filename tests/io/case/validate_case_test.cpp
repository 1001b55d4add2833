#include "io/case/case_file.h"

#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <fstream>

using namespace angiopose;

namespace {

using test::anyContains;

TEST(ValidateCase, ListsEveryProblem)
{
    test::SmallCase small;
    nlohmann::json json = small.json();
    EXPECT_TRUE(io::validateCase(small.write(json)).value().empty());
    json["vessel"]["centerline"]["path"] = "gone.vtp";
    json["angiogram"]["image"]["path"] = "gone.dcm";
    json["geometry"]["camera"]["fx"] = 0;
    const auto problems = io::validateCase(small.write(json));
    ASSERT_TRUE(problems);
    EXPECT_EQ(problems.value().size(), 3u);
    EXPECT_TRUE(anyContains(problems.value(), "gone.dcm"));
    EXPECT_TRUE(anyContains(problems.value(), "geometry.camera"));
}

TEST(DoubtsOfCase, HoldTheCaseAgainstTheHeaderOfItsImage)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const auto phantom = test::dataFile("coronary-phantom-xa");
    const auto doubtsWith = [&](const std::string& geometry) {
        const test::TemporaryFolder folder;
        const std::string path =
            folder.write("case.angiopose",
                         R"({"format": "angiopose-case", "version": 1, "vessel": {"centerline": {"path": ")" +
                             (phantom / "tree/Centerlines.vtk").string() + R"("}}, "angiogram": {"image": {"path": ")" +
                             (phantom / "views-A/IM3.dcm").string() + R"("}}, "geometry": )" + geometry + "}");
        const auto doubts = io::checkCaseGeometry(path);
        EXPECT_TRUE(doubts) << doubts.error().message;
        return doubts ? doubts.value() : core::Messages{};
    };
    EXPECT_TRUE(doubtsWith("{}").empty());
    ASSERT_EQ(doubtsWith(R"({"sourceToPatientMm": 900})").size(), 1U);
    EXPECT_NE(doubtsWith(R"({"sourceToPatientMm": 900})").front().text().find("behind the detector"),
              std::string::npos);
    EXPECT_NE(doubtsWith(R"({"imagerPixelSpacingMm": [0.2, 0.2]})").front().text().find("field of view"),
              std::string::npos);
}

TEST(CaseSchema, IsThePublishedFile)
{
    std::ifstream file(std::string(RESOURCES_DIR) + "/angiopose-case.schema.json");
    ASSERT_TRUE(file);
    const nlohmann::json published = nlohmann::json::parse(file);
    EXPECT_TRUE(published == nlohmann::json::parse(io::caseSchema())) << "angiopose-cli schema prints the new one";
    EXPECT_EQ(published["title"], "AngioPose case");
}

}   // namespace
