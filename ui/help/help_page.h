#pragma once

#include <QDialog>

class QWidget;

namespace angiopose::ui {

/// Shows a page of the built-in help in the UI language. Deletes itself when closed.
class HelpPage : public QDialog {
    Q_OBJECT
public:
    /// `page` is a path such as "panels/pose_panel" or "methods/nicp".
    HelpPage(const QString& page, const QString& title, QWidget* parent);

    /// Returns the page as Markdown, in English if it is not translated; empty if the page does not exist.
    static QString markdown(const QString& page);

    /// Returns the help page of the innermost panel around the widget, derived from the panel's class name: PosePanel →
    /// "panels/pose_panel". Falls back to the overview.
    static QString pageAbout(const QWidget* widget);
};

}   // namespace angiopose::ui
