#include "app/preferences/save_folder.h"
#include "app/files/sample_case.h"
#include "app/preferences/settings.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

class SaveFolder : public ::testing::Test {
protected:
    void SetUp() override { TearDown(); }
    void TearDown() override
    {
        settings::saveFolder.write({});
        settings::lastFolder.write({});
    }

    QTemporaryDir exports_, cases_, inputs_;
};

TEST_F(SaveFolder, IsWhereTheLastFileWasWritten)
{
    settings::lastFolder.write(inputs_.path());
    rememberSaveFolder(exports_.filePath("IM1.png"));
    EXPECT_EQ(saveFolder(cases_.filePath("IM1.angiopose")), exports_.path());
    EXPECT_EQ(suggestedPath({}, "IM2.png"), exports_.filePath("IM2.png"));
}

TEST_F(SaveFolder, IsBesideTheCaseBeforeWhereFilesWereOpened)
{
    settings::lastFolder.write(inputs_.path());
    EXPECT_EQ(saveFolder(cases_.filePath("IM1.angiopose")), cases_.path());
    EXPECT_EQ(saveFolder({}), inputs_.path());
}

TEST_F(SaveFolder, IsNeverOneThatIsGone)
{
    rememberSaveFolder(exports_.filePath("IM1.png"));
    ASSERT_TRUE(exports_.remove());
    EXPECT_EQ(saveFolder(cases_.filePath("IM1.angiopose")), cases_.path());
    EXPECT_TRUE(QDir(saveFolder("/nowhere/at/all/IM1.angiopose")).exists());
}

TEST_F(SaveFolder, IsNotAmongTheProgramsOwnFiles)
{
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample);
    settings::lastFolder.write(inputs_.path());
    EXPECT_EQ(saveFolder(sample.value()), inputs_.path());
}

}   // namespace
}   // namespace angiopose::app
