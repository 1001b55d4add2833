#include "ui/controls/section.h"

#include <gtest/gtest.h>
#include <QTest>
#include <QToolButton>

namespace angiopose::ui {
namespace {

TEST(Section, FoldsAtAClickWithoutAMarkAndByTheKeysWithOne)
{
    Section section(
        "test", [] { return QStringLiteral("Part"); }, Folding::Foldable);
    section.show();
    section.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&section));
    auto* arrow = section.findChild<QToolButton*>();
    arrow->clearFocus();
    QTest::mouseClick(arrow, Qt::LeftButton);
    EXPECT_TRUE(section.isFolded());
    EXPECT_FALSE(arrow->hasFocus());   // a focused arrow has a blue ground
    QTest::keyClick(&section, Qt::Key_Tab);
    EXPECT_TRUE(arrow->hasFocus());
    QTest::keyClick(arrow, Qt::Key_Space);
    EXPECT_FALSE(section.isFolded());
}

}   // namespace
}   // namespace angiopose::ui
