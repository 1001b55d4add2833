#pragma once

#include "app/window_host.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

#include <map>

namespace angiopose::test {

/// All texts, images and exports of an open case, without transient content such as notes, undo steps and write dates.
struct CaseSight {
    QStringList caseText;   ///< lines of the case file
    std::map<QString, QStringList> words;   ///< texts of each panel
    std::map<QString, QStringList> exports;   ///< line by line; an image as one entry
    std::map<QString, QImage> pictures;   ///< screenshots of each panel and of the image
};

/// Checked state of the commands, by name.
using Switches = std::map<QString, bool>;
Switches switchesOf(ui::MainWindow& window);

/// Lines of the case file that would be saved now in `folder`. The folder name does not matter because associated files
/// are named after the case. A single line with the error if the case cannot be saved.
QStringList caseTextOf(const core::Case& session, const QString& folder);

/// Captures an idle window after resetting it to the state of a freshly opened case, with the checked commands `fresh`
/// and the layout `layout`.
CaseSight sightOf(app::WindowHost& host, const Switches& fresh, const QByteArray& layout, const QString& folder);

/// Describes all differences; writes the differing images to `folder`.
QStringList differencesBetween(const CaseSight& before, const CaseSight& after, const QString& folder);

/// The first line that differs, if any.
QStringList differenceBetween(const QString& what, const QStringList& before, const QStringList& after);

}   // namespace angiopose::test
