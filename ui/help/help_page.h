#pragma once

#include <QDialog>

class QWidget;

namespace angiopose::ui {

/// A page of the help that is built into the program, in the language of the window. Deletes itself when closed.
class HelpPage : public QDialog {
    Q_OBJECT
public:
    /// `page`: "panels/pose_panel", "methods/nicp", …
    HelpPage(const QString& page, const QString& title, QWidget* parent);

    /// The page as Markdown, in English where the language has none; empty when there is no such page.
    static QString markdown(const QString& page);

    /// The page about the innermost panel around the widget, named like the panel's class: PosePanel →
    /// "panels/pose_panel". The overview where no panel has one.
    static QString pageAbout(const QWidget* widget);
};

}   // namespace angiopose::ui