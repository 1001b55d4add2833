#include "tests/app/open_window.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Writes a closed tube along x as an OBJ file, which states no unit.
QString writeTube(const QTemporaryDir& folder, double length, double radius)
{
    constexpr int around = 24, along = 60;
    QByteArray text;
    for (int i = 0; i <= along; ++i) {
        for (int k = 0; k < around; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / around;
            text += "v " + QByteArray::number(length * i / along) + ' ' + QByteArray::number(radius * std::cos(angle)) +
                    ' ' + QByteArray::number(radius * std::sin(angle)) + '\n';
        }
    }
    const auto corner = [](int i, int k) { return QByteArray::number(1 + i * around + k % around) + ' '; };
    for (int i = 0; i < along; ++i) {
        for (int k = 0; k < around; ++k) {
            text += "f " + corner(i, k) + corner(i, k + 1) + corner(i + 1, k + 1) + corner(i + 1, k) + '\n';
        }
    }
    for (const int end : {0, along}) {
        text += "f ";
        for (int k = 0; k < around; ++k) {
            text += corner(end, end == 0 ? around - k : k);
        }
        text += '\n';
    }
    const QString path = folder.filePath(QStringLiteral("tube.obj"));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return path;
}

TEST(WindowUnit, IsAskedWhereASurfaceIsTooSmallForMillimeters)
{
    const QTemporaryDir folder;
    OpenWindow w;
    w.drop({writeTube(folder, 0.24, 0.004)});
    EXPECT_FALSE(w.current().vessels.tree);
    const QList<QDialog*> asked = w.dialogs("unitQuestion");
    ASSERT_EQ(asked.size(), 1);
    OpenWindow::clickButton(asked.front(), QStringLiteral("m: 240 mm across"));
    ASSERT_TRUE(test::waitFor([&w] { return w.current().vessels.tree != nullptr; }));
    double lengthMm = 0.0;
    for (const core::VesselBranch& branch : w.current().vessels.tree->branches) {
        lengthMm += branch.lengthMm();
    }
    EXPECT_NEAR(lengthMm, 240.0, 24.0);
    EXPECT_EQ(w.current().vessels.input.unitMm, 1000.0) << "the case remembers";
}

TEST(WindowUnit, IsMillimetersWhereThatIsUsual)
{
    const QTemporaryDir folder;
    OpenWindow w;
    w.drop({writeTube(folder, 240.0, 4.0)});
    EXPECT_TRUE(w.dialogs("unitQuestion").isEmpty());
    ASSERT_TRUE(w.current().vessels.tree);
    EXPECT_EQ(w.current().vessels.input.unitMm, 0.0) << "nobody chose it";
}

TEST(WindowUnit, NothingOpensWhereNobodyKnowsIt)
{
    const QTemporaryDir folder;
    OpenWindow w;
    w.drop({writeTube(folder, 0.24, 0.004)});
    ASSERT_EQ(w.dialogs("unitQuestion").size(), 1);
    OpenWindow::clickButton(w.dialogs("unitQuestion").front(), QStringLiteral("Cancel"));
    QTest::qWait(100);
    EXPECT_FALSE(w.current().vessels.tree);
    EXPECT_FALSE(w.controller.isLoading());
}

QString writeLine(const QTemporaryDir& folder, double length)
{
    QByteArray text;
    for (int i = 0; i < 20; ++i) {
        text += QByteArray::number(length * i / 19.0) + ",0.25,0.5\n";
    }
    const QString path = folder.filePath(QStringLiteral("line.csv"));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return path;
}

TEST(WindowUnit, IsAskedForCenterlinesTooAndEnterTakesTheLikeliest)
{
    const QTemporaryDir folder;
    OpenWindow w;
    w.drop({writeLine(folder, 0.18)});
    EXPECT_FALSE(w.current().vessels.tree);
    ASSERT_EQ(w.dialogs("unitQuestion").size(), 1);
    ASSERT_TRUE(w.dialogs("unitQuestion").front()->focusWidget());
    QTest::keyClick(w.dialogs("unitQuestion").front()->focusWidget(), Qt::Key_Return);
    ASSERT_TRUE(test::waitFor([&w] { return w.current().vessels.tree != nullptr; }));
    EXPECT_NEAR(w.current().vessels.tree->branches.front().lengthMm(), 180.0, 1e-6);
    EXPECT_EQ(w.current().vessels.input.unitMm, 1000.0);
}

TEST(WindowUnit, BareTablesInMillimetersOpenAtOnce)
{
    const QTemporaryDir folder;
    OpenWindow w;
    w.drop({writeLine(folder, 180.0)});
    EXPECT_TRUE(w.dialogs("unitQuestion").isEmpty());
    ASSERT_TRUE(w.current().vessels.tree);
    EXPECT_EQ(w.current().vessels.tree->pointCount(), 20U);
}

}   // namespace
}   // namespace angiopose::app
