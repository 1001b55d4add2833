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
    EXPECT_FALSE(arrow->hasFocus());   // a focused arrow has a blue background
    QTest::keyClick(&section, Qt::Key_Tab);
    EXPECT_TRUE(arrow->hasFocus());
    QTest::keyClick(arrow, Qt::Key_Space);
    EXPECT_FALSE(section.isFolded());
}

}   // namespace
/// Height reported by a newly created label without cached values.
int heightOfNewLabel(const QLabel& like, int width)
{
    QLabel* fresh = ui::roleLabel("hint", like.text());
    const std::unique_ptr<QLabel> owner(fresh);
    ui::setRole(fresh, like.property("role").toByteArray().constData());
    fresh->setFont(like.font());
    fresh->setWordWrap(true);
    return fresh->heightForWidth(width);
}

TEST(RoleLabel, KnowsItsHeightAfterEveryChange)
{
    const std::unique_ptr<QLabel> label(
        ui::roleLabel("hint", QStringLiteral("Some words that are longer than a line")));
    label->setWordWrap(true);
    const auto expectSame = [&label] {
        for (const int width : {60, 120, 400, 60}) {
            EXPECT_EQ(label->heightForWidth(width), heightOfNewLabel(*label, width)) << width;
        }
    };
    expectSame();
    const int before = label->heightForWidth(120);
    label->setText(label->text().repeated(5));
    EXPECT_GT(label->heightForWidth(120), before);
    expectSame();
    QFont large = label->font();
    large.setPixelSize(40);
    label->setFont(large);
    expectSame();
    ui::setRole(label.get(), "heading");
    expectSame();
}

}   // namespace angiopose::ui
