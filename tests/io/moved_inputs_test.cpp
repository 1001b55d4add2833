#include "io/case/moved_inputs.h"
#include "io/messages/messages.h"

#include "io/case/case_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

/// A phantom case with copies of its two inputs.
class MovedCase {
public:
    MovedCase()
    {
        core::Messages warnings;
        const auto path = test::dataFile("coronary-phantom-xa/cases/IM4.angiopose");
        core::Case values = io::loadCase(path.string(), warnings).value();
        tree_ = copied(values.vessels.file.path, "inputs");
        image_ = copied(values.shown().imageFile.path, "inputs");
        values.vessels.file.path = tree_.string();
        values.shown().imageFile.path = image_.string();
        EXPECT_TRUE(io::saveCase(values, casePath()));
    }

    std::string casePath() const { return folder_.file("moved.angiopose"); }
    const fs::path& tree() const { return tree_; }
    const fs::path& image() const { return image_; }
    fs::path root() const { return fs::path(casePath()).parent_path(); }

private:
    fs::path copied(const std::string& from, const char* into) const
    {
        const fs::path to = fs::path(folder_.file(into)) / fs::path(from).filename();
        fs::create_directories(to.parent_path());
        fs::copy_file(from, to);
        return to;
    }

    test::TemporaryFolder folder_;
    fs::path tree_;
    fs::path image_;
};

TEST(MovedInputs, NothingIsMissingWhereAllIsInPlace)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const MovedCase moved;
    const auto missing = io::findMissingInputs(moved.casePath());
    ASSERT_TRUE(missing) << missing.error().message;
    EXPECT_TRUE(missing.value().empty());
}

TEST(MovedInputs, AreFoundInSubFoldersEvenUnderAnotherName)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const MovedCase moved;
    const fs::path newTree = moved.root() / "a" / "b" / moved.tree().filename();
    const fs::path newImage = moved.root() / ("renamed" + moved.image().extension().string());
    fs::create_directories(newTree.parent_path());
    fs::rename(moved.tree(), newTree);
    fs::rename(moved.image(), newImage);

    core::Messages warnings;
    EXPECT_FALSE(io::loadCase(moved.casePath(), warnings));
    const auto missing = io::findMissingInputs(moved.casePath());
    ASSERT_TRUE(missing);
    ASSERT_EQ(missing.value().size(), 2u);
    const io::MovedInputs found = io::findMovedInputs(missing.value(), {moved.root().string()});
    ASSERT_EQ(found.size(), 2u);

    const auto loaded = io::loadCase(moved.casePath(), warnings, {}, found);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(fs::equivalent(loaded.value().vessels.file.path, newTree));
    EXPECT_TRUE(fs::equivalent(loaded.value().shown().imageFile.path, newImage));
    for (const core::Message& warning : warnings) {
        EXPECT_FALSE(warning.is(io::messages::caseFileChanged)) << warning;
    }
}

TEST(MovedInputs, AnotherFileOfTheSameNameDoesNotCount)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const MovedCase moved;
    fs::remove(moved.tree());
    const fs::path impostor = moved.root() / "other" / moved.tree().filename();
    fs::create_directories(impostor.parent_path());
    std::ofstream(impostor) << "not the tree";

    const auto missing = io::findMissingInputs(moved.casePath());
    ASSERT_TRUE(missing);
    ASSERT_EQ(missing.value().size(), 1u);
    EXPECT_TRUE(io::findMovedInputs(missing.value(), {moved.root().string()}).empty());
    EXPECT_FALSE(io::canReplace(missing.value().front(), impostor.string()));
    EXPECT_TRUE(io::canReplace({impostor.string(), ""}, impostor.string()));
}

TEST(MovedInputs, SearchEndsWhenAskedTo)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const MovedCase moved;
    fs::rename(moved.tree(), moved.root() / moved.tree().filename());
    const auto missing = io::findMissingInputs(moved.casePath());
    ASSERT_TRUE(missing);
    const auto stop = [](double) { return core::ObserverDecision::Stop; };
    EXPECT_TRUE(io::findMovedInputs(missing.value(), {moved.root().string()}, stop).empty());
}

}   // namespace
