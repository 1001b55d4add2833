#include "tests/app/session/random_walk.h"

#include "tests/app/session/case_sight.h"
#include "tests/app/session/random_user.h"
#include "tests/app/session/words_of_window.h"
#include "tests/app/wait_for.h"
#include "ui/views/angiogram_view.h"

#include <QDir>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QTest>

#include <stdexcept>
#include <utility>

namespace angiopose::test {
namespace {

template <class Condition>
void waitUntil(const char* what, const Condition& condition)
{
    if (!test::waitFor(condition)) {
        throw std::runtime_error(std::string("does not happen: ") + what);
    }
}

/// Waits until nothing that could change the display is being computed.
void settle(app::CaseController& controller)
{
    waitUntil("rest", [&controller] { return !controller.isBusy() && !controller.target().isTracing(); });
    QTest::qWait(1000);
}

void open(app::WindowHost& host, const QStringList& files)
{
    app::CaseController& controller = host.controller();
    host.window().resize(1400, 900);
    controller.open(files);
    waitUntil("opening", [&] { return !controller.isLoading() && !controller.document().isEmpty(); });
    waitUntil("a judgement", [&controller] { return controller.evaluation() || controller.target().problem(); });
    settle(controller);
}

void registerVessels(app::WindowHost& host)
{
    host.window().actions()[ui::Command::Register]->trigger();
    waitUntil("the end of a registration", [&host] { return !host.controller().registration().isRunning(); });
}

QString savedIn(app::CaseController& controller, const QString& folder)
{
    QDir().mkpath(folder);
    const QString path = folder + QStringLiteral("/case.angiopose");
    bool isSaved = false;
    controller.saveController().saveTo(path, [&isSaved] { isSaved = true; });
    waitUntil("saving", [&isSaved] { return isSaved; });
    return path;
}

/// Moves to that position in the undo stack with the shortcut of the command.
void repeat(app::WindowHost& host, ui::Command command, int place)
{
    constexpr int maxSteps = 1000;
    host.window().activateWindow();
    waitUntil("a window that hears its keys", [&host] { return host.window().isActiveWindow(); });
    QUndoStack& steps = host.controller().document().undoStack();
    const auto isLeft = [&] { return steps.index() != place; };
    const QKeySequence key = host.window().actions()[command]->shortcut();
    for (int i = 0; i < maxSteps && isLeft(); ++i) {
        QTest::keySequence(&host.window().angiogramView(), key);
    }
    if (isLeft()) {
        throw std::runtime_error("does not go on: " + steps.undoText().toStdString());
    }
    settle(host.controller());
}

class Walk {
public:
    explicit Walk(const RandomWalk& plan) : plan_(plan)
    {
        timer_.start();
        open(host_, plan.files);
        fresh_ = switchesOf(host_.window());
        layout_ = host_.window().layoutState();
    }

    void tell(const char* stage)
    {
        if (plan_.reported) {
            plan_.reported(QStringLiteral("[%1: %2 s]")
                               .arg(QLatin1String(stage))
                               .arg(1e-3 * static_cast<double>(timer_.restart()), 0, 'f', 1));
        }
    }

    QStringList textIn(const char* name) { return caseTextOf(host_.controller().document().current(), folder(name)); }

    /// Texts of the result panel, without empty entries: Qt creates parts of its lists on first use.
    QStringList wordsOfResult()
    {
        static const QRegularExpression withWords(QStringLiteral("^[^|]*\\|[^|]*\\|.*[^|]"));
        return wordsOf(host_.window().result()).filter(withWords);
    }

    void work()
    {
        RandomUser user(host_, plan_.seed);
        for (int i = 0; i < plan_.actions; ++i) {
            user.act();
            if (plan_.reported) {
                plan_.reported(user.lastAction());
            }
            if (i == plan_.actions / 2) {
                registerVessels(host_);
            }
        }
        if (plan_.seed % 2 == 0) {   // otherwise the edits since the registration are assessed
            registerVessels(host_);
        }
        if (!user.comeToRest()) {
            throw std::runtime_error("does not come to rest after: " + user.lastAction().toStdString());
        }
    }

    QStringList changedByReopening()
    {
        const QString path = savedIn(host_.controller(), folder("saved"));
        const CaseSight before = restingSight();
        host_.window().hide();
        app::WindowHost other;
        open(other, {path});
        QStringList changed;
        for (int look = 0; look < maxLooks && (look == 0 || !changed.isEmpty()); ++look) {
            QTest::qWait(look == 0 ? 0 : 1000);
            changed = differencesBetween(before, sightOf(other, fresh_, layout_, folder("after")), plan_.folder);
        }
        host_.window().show();
        return changed;
    }

    void undoAll()
    {
        end_ = host_.controller().document().undoStack().index();   // steps undone before lie after it
        repeat(host_, ui::Command::Undo, 0);
    }
    void redoAll() { repeat(host_, ui::Command::Redo, end_); }

private:
    static constexpr int maxLooks = 10;   // results of workers may come late on a busy machine

    /// Captures the window until two captures in a row are equal.
    CaseSight restingSight()
    {
        CaseSight sight = sightOf(host_, fresh_, layout_, folder("before"));
        for (int look = 0; look < maxLooks; ++look) {
            QTest::qWait(500);
            CaseSight next = sightOf(host_, fresh_, layout_, folder("before"));
            if (differencesBetween(sight, next, folder("before")).isEmpty()) {
                return next;
            }
            sight = std::move(next);
        }
        throw std::runtime_error("does not come to rest on the screen");
    }

    QString folder(const char* name) const { return plan_.folder + QLatin1Char('/') + QLatin1String(name); }

    RandomWalk plan_;
    QElapsedTimer timer_;
    app::WindowHost host_;
    Switches fresh_;   ///< of a window that has just opened the case
    QByteArray layout_;
    int end_ = 0;   ///< position in the undo stack at the end of the walk
};

}   // namespace

QStringList surprisesOf(const RandomWalk& plan)
{
    try {
        Walk walk(plan);
        const QStringList start = walk.textIn("start");
        const QStringList resultAtStart = walk.wordsOfResult();
        walk.tell("opened");
        walk.work();
        walk.tell("worked");
        QStringList surprises = walk.changedByReopening();
        walk.tell("reopened");
        const QStringList end = walk.textIn("end");
        walk.undoAll();
        walk.tell("undone");
        surprises << differenceBetween(QStringLiteral("undone"), start, walk.textIn("undone"));
        surprises << differenceBetween(QStringLiteral("undone result"), resultAtStart, walk.wordsOfResult());
        walk.redoAll();
        walk.tell("redone");
        surprises << differenceBetween(QStringLiteral("redone"), end, walk.textIn("redone"));
        return surprises;
    } catch (const std::runtime_error& stuck) {
        return {QString::fromUtf8(stuck.what())};
    }
}

}   // namespace angiopose::test
