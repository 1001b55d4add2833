#pragma once

#include "app/case_controller.h"
#include "app/files/sample_case.h"
#include "app/preferences/settings.h"
#include "tests/app/wait_for.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/main_window.h"
#include "ui/theme/without_style_sheet.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTest>

#include <optional>

namespace angiopose::test {

/// A visible window with the complete application behind it, driven by real events.
class OpenWindow {
public:
    OpenWindow()
    {
        undressed.reset();
        window.resize(1400, 900);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~OpenWindow()
    {
        controller.registration().stop();
        EXPECT_TRUE(test::waitFor([this] { return !controller.registration().isRunning(); }));
    }

    /// Opens files by drag and drop and waits until they are loaded or rejected.
    void drop(const QStringList& paths)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths) {
            urls << QUrl::fromLocalFile(path);
        }
        data.setUrls(urls);
        const QPointF place(700, 400);
        QDragEnterEvent enter(place.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &event);
        EXPECT_TRUE(test::waitFor([this] { return !controller.isLoading(); }));
    }

    /// Opens the simulated sample and waits until its initial pose has been assessed.
    void openSample()
    {
        static const auto sample = app::writeSampleCase();
        ASSERT_TRUE(sample) << sample.error().message;
        drop({sample.value()});
        waitForJudgement();
    }

    void waitForJudgement()
    {
        EXPECT_TRUE(test::waitFor([this] { return controller.evaluation() != nullptr; }));
    }

    void waitForRun()
    {
        EXPECT_TRUE(test::waitFor([this] { return !controller.registration().isRunning(); }));
    }

    void registerVessels()
    {
        press(Qt::Key_R);
        waitForRun();
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&window.angiogramView(), key, modifiers);
    }

    const core::Case& current() { return controller.document().current(); }
    QUndoStack& history() { return controller.document().undoStack(); }

    QList<QDialog*> dialogs(const char* objectName)
    {
        QList<QDialog*> open;
        for (QDialog* dialog : window.findChildren<QDialog*>(QString::fromLatin1(objectName))) {
            if (dialog->isVisible()) {
                open << dialog;
            }
        }
        return open;
    }

    /// Enters a path in the file dialog that is open or opens next, saves, and waits for the file.
    void saveAs(const QString& path)
    {
        QFileDialog* files = nullptr;
        const auto isThere = [&] { return (files = window.findChild<QFileDialog*>()) && files->isVisible(); };
        ASSERT_TRUE(test::waitFor(isThere));
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        QTest::mouseClick(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
        EXPECT_TRUE(test::waitFor([&path] { return QFile::exists(path); }));
    }

    /// Returns whether the case was saved in time.
    bool saveCase(const QString& path)
    {
        bool isSaved = false;
        controller.saveController().saveTo(path, [&isSaved] { isSaved = true; });
        return test::waitFor([&isSaved] { return isSaved; });
    }

    static void clickButton(const QDialog* dialog, const QString& text)
    {
        for (QPushButton* button : dialog->findChildren<QPushButton*>()) {
            if (button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        FAIL() << "no button " << text.toStdString();
    }

    /// Clears the brightness settings that an earlier test stored for the sample.
    struct FreshBrightness {
        FreshBrightness() { app::settings::brightness.write({}); }
    } fresh;
    std::optional<ui::WithoutStyleSheet> undressed{
        std::in_place};   ///< during construction of the window, as in the program
    ui::MainWindow window;
    app::CaseController controller{window};
};

/// A window in which the sample is open.
struct SampleWindow : OpenWindow {
    SampleWindow() { openSample(); }
};

inline double distance(const core::RigidTransform& a, const core::RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}   // namespace angiopose::test
