#pragma once

#include "app/window_host.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

#include <map>

namespace angiopose::test {

/// All that an open case says, shows and gives away. Without what is of the moment: notes, steps of undo, dates of
/// writing.
struct CaseSight {
    QStringList caseText;   ///< lines of the case file
    std::map<QString, QStringList> words;   ///< of each panel
    std::map<QString, QStringList> exports;   ///< by lines; pictures as one word
    std::map<QString, QImage> pictures;   ///< of each panel and of the image
};

/// Which commands are switched on, by name.
using Switches = std::map<QString, bool>;
Switches switchesOf(ui::MainWindow& window);

/// Lines of the case file as it would be saved now in `folder`, whose name does not matter: files that belong to a case
/// are named after the case. One line of words where it cannot be saved.
QStringList caseTextOf(const core::Case& session, const QString& folder);

/// Of a window at rest, which is first put back to how it shows a case that was just opened: `fresh` are its switches
/// then, `layout` its places.
CaseSight sightOf(app::WindowHost& host, const Switches& fresh, const QByteArray& layout, const QString& folder);

/// In words, what is not the same; `folder` gets the pictures that differ.
QStringList differencesBetween(const CaseSight& before, const CaseSight& after, const QString& folder);

/// The first line that is not the same, if any.
QStringList differenceBetween(const QString& what, const QStringList& before, const QStringList& after);

}   // namespace angiopose::test
