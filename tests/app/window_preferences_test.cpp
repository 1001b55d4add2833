#include "tests/app/open_window.h"

#include "app/preferences/settings.h"
#include "ui/dialogs/key_sheet.h"

#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QTreeWidget>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

/// The list of keyboard shortcuts with the row of a command selected.
struct OpenSheet {
    explicit OpenSheet(OpenWindow& window)
    {
        window.press(Qt::Key_F1, Qt::ControlModifier);
        sheet = window.window.findChild<ui::KeySheet*>();
        list = sheet ? sheet->findChild<QTreeWidget*>() : nullptr;
    }

    QTreeWidgetItem* lineOf(const char* effect) const
    {
        for (int i = 0; i < list->topLevelItemCount(); ++i) {
            if (list->topLevelItem(i)->text(1) == QString::fromUtf8(effect)) {
                return list->topLevelItem(i);
            }
        }
        return nullptr;
    }

    void startRecording(const char* effect) const
    {
        list->setFocus();
        list->setCurrentItem(lineOf(effect));
        QTest::keyClick(list, Qt::Key_Return);
        EXPECT_TRUE(sheet->isRecording());
    }

    QString word() const { return sheet->findChildren<QLabel*>().last()->text(); }

    ui::KeySheet* sheet = nullptr;
    QTreeWidget* list = nullptr;
};

class WindowPreferences : public ::testing::Test {
protected:
    void TearDown() override
    {
        QSettings().remove(QStringLiteral("keys"));
        settings::mouse.write(settings::mouse.fallback);
    }
};

TEST_F(WindowPreferences, AKeyIsChangedInTheSheetAndHoldsInTheNextWindow)
{
    {
        OpenWindow w;
        const OpenSheet open(w);
        ASSERT_TRUE(open.list);
        open.startRecording("Invert grayscale");
        QTest::keyClick(open.list, Qt::Key_F4);
        EXPECT_EQ(open.lineOf("Invert grayscale")->text(0), QStringLiteral("F4"));
        open.sheet->close();
        w.press(Qt::Key_F4);
        EXPECT_TRUE(w.window.actions()[ui::Command::Invert]->isChecked());
    }
    OpenWindow again;
    again.press(Qt::Key_I);
    EXPECT_FALSE(again.window.actions()[ui::Command::Invert]->isChecked());
    again.press(Qt::Key_F4);
    EXPECT_TRUE(again.window.actions()[ui::Command::Invert]->isChecked());
}

TEST_F(WindowPreferences, AKeyOfAnotherCommandIsTakenOnlyWhenPressedTwice)
{
    OpenWindow w;
    const OpenSheet open(w);
    open.startRecording("Invert grayscale");
    QTest::keyClick(open.list, Qt::Key_N);
    EXPECT_TRUE(open.sheet->isRecording());
    EXPECT_EQ(w.window.actions()[ui::Command::Nudge]->shortcut(), QKeySequence(Qt::Key_N));
    QTest::keyClick(open.list, Qt::Key_N);
    EXPECT_EQ(w.window.actions()[ui::Command::Invert]->shortcut(), QKeySequence(Qt::Key_N));
    EXPECT_TRUE(w.window.actions()[ui::Command::Nudge]->shortcut().isEmpty());

    OpenWindow::clickButton(open.sheet, QStringLiteral("Reset all shortcuts"));
    EXPECT_EQ(w.window.actions()[ui::Command::Invert]->shortcut(), QKeySequence(Qt::Key_I));
    EXPECT_EQ(w.window.actions()[ui::Command::Nudge]->shortcut(), QKeySequence(Qt::Key_N));
}

TEST_F(WindowPreferences, EscKeepsTheOldKeyAndKeysThatAreNeededAreRefused)
{
    OpenWindow w;
    const OpenSheet open(w);
    open.startRecording("Invert grayscale");
    QTest::keyClick(open.list, Qt::Key_H);
    EXPECT_TRUE(open.sheet->isRecording());
    QTest::keyClick(open.list, Qt::Key_Escape);
    EXPECT_FALSE(open.sheet->isRecording());
    EXPECT_TRUE(open.sheet->isVisible());
    EXPECT_EQ(w.window.actions()[ui::Command::Invert]->shortcut(), QKeySequence(Qt::Key_I));
}

TEST_F(WindowPreferences, NoKeyMeansTwoThings)
{
    OpenWindow w;
    std::map<QString, QString> owner;
    for (const ui::ShortcutRow& line : w.window.actions().shortcutRows({})) {
        for (const QKeySequence& key : line.action ? line.action->shortcuts() : QList<QKeySequence>()) {
            const QString name = key.toString();
            EXPECT_TRUE(owner.emplace(name, line.effect).second)
                << name.toStdString() << ": " << owner[name].toStdString() << ", " << line.effect.toStdString();
        }
    }
    EXPECT_GT(owner.size(), 40U);
}

void dragDown(QWidget& view, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    const QPoint from = view.rect().center();
    QTest::mousePress(&view, button, modifiers, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(0, 30), view.mapToGlobal(from + QPoint(0, 30)), button, button,
                     modifiers);
    QApplication::sendEvent(&view, &move);
    QMouseEvent further(QEvent::MouseMove, from + QPoint(0, 60), view.mapToGlobal(from + QPoint(0, 60)), button, button,
                        modifiers);
    QApplication::sendEvent(&view, &further);
    QTest::mouseRelease(&view, button, modifiers, from + QPoint(0, 60));
}

TEST_F(WindowPreferences, TheMouseFollowsThePreset)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    const auto level = [&view] { return view.shownRange().level(); };

    double before = level();
    dragDown(view, Qt::LeftButton);
    EXPECT_NE(level(), before);

    w.window.actions()[ui::Command::MouseSlicer]->trigger();
    before = level();
    const ui::ViewRect seen = view.visiblePart();
    dragDown(view, Qt::LeftButton);
    EXPECT_EQ(level(), before);
    dragDown(view, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(view.visiblePart().top, seen.top);
    dragDown(view, Qt::LeftButton, Qt::ControlModifier);
    EXPECT_NE(level(), before);

    w.window.actions()[ui::Command::MouseScroll]->trigger();
    const int frame = w.current().shown().frame;
    w.press(Qt::Key_Home);
    dragDown(view, Qt::LeftButton);
    EXPECT_GT(w.current().shown().frame, 0);
    EXPECT_GE(frame, 0);
}

TEST_F(WindowPreferences, ARightClickOpensAMenuARightDragDoesNot)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    dragDown(view, Qt::RightButton);
    EXPECT_FALSE(w.window.findChild<QMenu*>(QStringLiteral("contextMenu")));
    for (QWidget* clicked : {static_cast<QWidget*>(&view), static_cast<QWidget*>(&w.window.treeView())}) {
        QTest::mouseClick(clicked, Qt::RightButton, Qt::NoModifier, QPoint(40, 40));
        auto* menu = w.window.findChild<QMenu*>(QStringLiteral("contextMenu"));
        ASSERT_TRUE(menu);
        EXPECT_GT(menu->actions().size(), 3);
        menu->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

TEST_F(WindowPreferences, TheWindowGoesToTheClipboardAsAPicture)
{
    OpenWindow w;
    w.press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage picture = QApplication::clipboard()->image();
    EXPECT_EQ(picture.size(), w.window.size() * w.window.devicePixelRatioF());
}

}   // namespace
}   // namespace angiopose::app
