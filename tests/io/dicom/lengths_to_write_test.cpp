#include "core/messages/messages.h"
#include "io/angiogram_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

TEST(LengthsToWrite, ArePositiveInARun)
{
    const test::TemporaryFolder folder;
    for (const double length : {0.0, std::nan("")}) {
        core::Angiogram run;
        run.frames.emplace_back(24, 18, 100.0F);
        EXPECT_TRUE(io::writeAngiogram(run, folder.file("sound.dcm")));
        run.cArm.rowSpacingMm = run.cArm.columnSpacingMm = {length, core::Origin::User, ""};
        EXPECT_TRUE(io::writeAngiogram(run, folder.file("run.dcm")).error().message.is(core::messages::valueMissing));
        run.cArm.rowSpacingMm = run.cArm.columnSpacingMm = {0.3, core::Origin::User, ""};
        run.cArm.sourceToDetectorMm = {length, core::Origin::User, ""};
        EXPECT_TRUE(io::writeAngiogram(run, folder.file("run.dcm")).error().message.is(core::messages::valueMissing));
    }
}

}   // namespace
