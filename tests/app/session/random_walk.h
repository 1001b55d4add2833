#pragma once

#include <QStringList>

#include <cstdint>
#include <functional>

namespace angiopose::test {

/// Opens a case, works on it at random, registers, saves and reopens it in another window, then undoes and redoes every
/// step.
struct RandomWalk {
    QStringList files;   ///< files to open
    std::uint64_t seed = 1;   ///< the same seed always makes the same choices
    int actions = 20;
    QString folder;   ///< folder for the written files
    std::function<void(const QString& action)> reported = {};   ///< called for each action
};

/// Describes the unexpected differences: between the window before saving and after reopening; between the case at the
/// start and after undoing everything, including the texts of the result; and between the saved case and the one after
/// redoing everything. Empty if there are none.
QStringList surprisesOf(const RandomWalk& walk);

}   // namespace angiopose::test
