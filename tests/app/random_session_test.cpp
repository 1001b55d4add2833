#include "tests/app/open_window.h"
#include "tests/app/session/random_user.h"
#include "tests/app/session/session_check.h"

#include <QTemporaryDir>

namespace app {
namespace {

// The long version, with times and memory, is tests/benchmark/random_session.
TEST(RandomSession, EndsWithACaseThatReopensAsItWas)
{
    const QTemporaryDir folder;
    test::OpenWindow w;
    w.openSample();
    test::RandomUser user(w.window, w.controller, 5);
    for (int i = 0; i < 250; ++i) {
        user.act();
        ASSERT_TRUE(w.window.isVisible()) << user.lastAction().toStdString();
    }
    w.controller.registration().stop();
    w.waitForRun();
    ASSERT_FALSE(w.controller.document().isEmpty());
    const QString difference = test::differenceAfterReopening(w.controller, folder.path());
    EXPECT_TRUE(difference.isEmpty()) << difference.toStdString();
}

}   // namespace
}   // namespace app
