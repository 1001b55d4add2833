#pragma once

#include <QStringList>

#include <cstdint>
#include <functional>

namespace angiopose::test {

/// A case that is opened, worked on at random, registered, saved and reopened in another window; then every step is
/// undone, and done again.
struct RandomWalk {
    QStringList files;   ///< what is opened
    std::uint64_t seed = 1;   ///< the same seed always makes the same choices
    int actions = 20;
    QString folder;   ///< for what is written
    std::function<void(const QString& action)> reported = {};   ///< what is done, as it is done
};

/// What went differently: what differs between the window as it was left and as it is reopened, between the case at the
/// start and after undoing everything, with what is told of the result, between what was saved and after doing
/// everything again. Empty: nothing.
QStringList surprisesOf(const RandomWalk& walk);

}   // namespace angiopose::test
