#include "tests/io/case/small_case.h"

#include <functional>

using namespace angiopose;

namespace {

using Edit = std::function<void(nlohmann::json&)>;

core::RegistrationResult resultAt(const core::View& view)
{
    core::RegistrationResult result;
    result.method = "angiopose";
    result.cameraFromPatient = view.cameraFromPatient;
    return result;
}

/// A case of two views, each with a result, as saved by the window.
class ResultSeal : public ::testing::Test {
protected:
    ResultSeal()
    {
        auto loaded = small.load(small.json());
        EXPECT_TRUE(loaded);
        session = std::move(loaded).value();
        session.views.push_back(session.shown());
        for (core::View& view : session.views) {
            view.result = resultAt(view);
        }
        EXPECT_TRUE(io::saveCase(session, small.path("saved.angiopose")));
    }

    core::Case afterEditing(const Edit& edit)
    {
        nlohmann::json json = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
        edit(json);
        small.folder().write("edited.angiopose", json.dump(1));
        small.warnings.clear();
        return test::loadedFrom(small.path("edited.angiopose"), small.warnings);
    }

    bool saysChanged(const std::string& what) const
    {
        return test::anyContains(small.warnings, "have changed since it was computed: " + what + ". Register again.");
    }

    test::SmallCase small;
    core::Case session;
};

TEST_F(ResultSeal, HoldsWhereNothingWasChanged)
{
    const core::Case copy = afterEditing([](nlohmann::json&) {});
    EXPECT_TRUE(copy.views[0].result);
    EXPECT_TRUE(copy.views[1].result);
    EXPECT_FALSE(test::anyContains(small.warnings, "Register again"));
}

TEST_F(ResultSeal, NamesWhatWasChangedBesideTheShownView)
{
    const std::vector<std::pair<std::string, Edit>> edits{
        {"the geometry", [](auto& json) { json["geometry"]["camera"]["fx"] = -2001; }},
        {"the frame", [](auto& json) { json["angiogram"].erase("frame"); }},
        {"the image", [](auto& json) { json["angiogram"]["image"]["dicom"]["seriesInstanceUid"] = "1.2.3"; }},
        {"the traced curves", [](auto& json) { json["angiogram"]["trace"]["sensitivity"] = 1.25; }},
        {"the subtraction",
         [](auto& json) {
             json["angiogram"]["subtraction"] = {{"on", false}};
         }},
        {"the initial pose", [](auto& json) { json["pose"]["initial"]["cameraFromPatient"][0][3] = 2.0; }},
    };
    for (const auto& [what, edit] : edits) {
        const core::Case copy = afterEditing(edit);
        EXPECT_FALSE(copy.views[0].result) << what;
        EXPECT_TRUE(copy.views[1].result) << what;
        EXPECT_TRUE(saysChanged(what)) << what;
        EXPECT_TRUE(test::anyContains(small.warnings, "image.png: ")) << what;
    }
}

TEST_F(ResultSeal, NamesWhatWasChangedBesideAllViews)
{
    const std::vector<std::pair<std::string, Edit>> edits{
        {"the excluded branches", [](auto& json) { json["vessel"]["excludedBranches"] = {2}; }},
        {"the auxiliary branches", [](auto& json) { json["vessel"]["auxiliaryBranches"] = {1}; }},
        {"the vessels", [](auto& json) { json["vessel"]["unitMm"] = 1.5; }},
        {"the locked degrees of freedom", [](auto& json) { json["pose"]["locked"] = {"along-ray"}; }},
        {"the locked degrees of freedom",
         [](auto& json) {
             json["vessel"]["pivotInPatientMm"] = {1, 2, 3};
         }},
        {"the method", [](auto& json) { json["method"] = "dynaweight"; }},
        {"the options", [](auto& json) { json["options"]["maxIterations"] = 61; }},
    };
    for (const auto& [what, edit] : edits) {
        const core::Case copy = afterEditing(edit);
        EXPECT_FALSE(copy.views[0].result) << what;
        EXPECT_FALSE(copy.views[1].result) << what;
        EXPECT_TRUE(saysChanged(what)) << what;
    }
}

TEST_F(ResultSeal, NamesSeveralInARowAndTheOtherViewByItself)
{
    const core::Case copy = afterEditing([](nlohmann::json& json) {
        json["views"][0]["geometry"]["camera"]["cx"] = 8;
        json["views"][0]["angiogram"]["trace"]["minBranchLengthPx"] = 11;
    });
    EXPECT_TRUE(copy.views[0].result);
    EXPECT_FALSE(copy.views[1].result);
    EXPECT_TRUE(saysChanged("the traced curves, the geometry"));
}

TEST_F(ResultSeal, HoldsWhereTheFileSaysTheSameInOtherWords)
{
    const core::Case copy = afterEditing([](nlohmann::json& json) {
        nlohmann::json& camera = json["geometry"]["camera"];
        camera["fx"] =
            static_cast<int>(camera["fx"].get<double>());   // -2000 instead of -2000.0, as other programs write it
        json["title"] = "Renamed";
        json["vessel"]["hiddenBranches"] = {2};
        json["angiogram"]["name"] = "left";
        json["angiogram"]["image"]["path"] = "./in/../in/image.png";
    });
    EXPECT_TRUE(copy.views[0].result);
    EXPECT_TRUE(copy.views[1].result);
}

TEST_F(ResultSeal, IsMissingInOldFilesWhichReadAsBefore)
{
    const core::Case copy = afterEditing([](nlohmann::json& json) {
        json["result"].erase("savedWith");
        json["geometry"]["camera"]["fx"] = -2001;
    });
    EXPECT_TRUE(copy.views[0].result);
}

TEST_F(ResultSeal, IsThatOfTheCaseAsItIsSavedNow)
{
    core::Case copy = afterEditing([](nlohmann::json& json) { json["geometry"]["note"] = "kept"; });   // an unknown key
    EXPECT_FALSE(copy.views[0].result);
    copy.views[0].result = resultAt(copy.views[0]);
    ASSERT_TRUE(io::saveCase(copy, small.path("saved.angiopose")));
    EXPECT_TRUE(afterEditing([](nlohmann::json&) {}).views[0].result);
}

}   // namespace
