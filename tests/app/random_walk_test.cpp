#include "tests/app/session/random_walk.h"

#include "app/files/sample_case.h"
#include "ui/words/language.h"

#include <gtest/gtest.h>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

// Forty walks on other cases: tests/benchmark/random_walks.
TEST(RandomWalk, ReopensAsItWasLeftAndIsUndoneToTheStart)
{
    const QTemporaryDir folder;
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample) << sample.error().message;
    for (const std::uint64_t seed : {1U, 2U}) {
        const QString own = folder.filePath(QString::number(seed));
        const QStringList surprises = test::surprisesOf({{sample.value()}, seed, 20, own});
        EXPECT_TRUE(surprises.isEmpty()) << "seed " << seed << ": " << surprises.join(QLatin1Char('\n')).toStdString();
    }
    ui::applyLanguage(QStringLiteral("en"));   // as the other tests expect it
}

}   // namespace
}   // namespace angiopose::app
