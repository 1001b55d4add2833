#include "tests/app/open_window.h"
#include "tests/app/session/random_user.h"
#include "tests/app/session/session_check.h"
#include "ui/words/language.h"

#include <QTemporaryDir>

namespace angiopose::app {
namespace {

// The long version, with times and memory, is tests/benchmark/random_session.
TEST(RandomSession, EndsWithACaseThatReopensAsItWas)
{
    const QTemporaryDir folder;
    WindowHost host;
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample) << sample.error().message;
    host.controller().open({sample.value()});
    ASSERT_TRUE(test::waitFor([&] { return host.controller().evaluation() != nullptr; }));
    test::RandomUser user(host, 5);
    for (int i = 0; i < 250; ++i) {
        user.act();
        ASSERT_TRUE(host.window().isVisible()) << user.lastAction().toStdString();
    }
    ASSERT_TRUE(user.comeToRest()) << user.lastAction().toStdString();
    ASSERT_FALSE(host.controller().document().isEmpty());
    const QString difference = test::differenceAfterReopening(host.controller(), folder.path());
    EXPECT_TRUE(difference.isEmpty()) << difference.toStdString();
    ui::applyLanguage(QStringLiteral("en"));   // as the other tests expect it
}

}   // namespace
}   // namespace angiopose::app
