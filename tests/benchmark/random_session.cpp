// A long session of random but valid user actions (issue 5): must end without a crash, a leak above 20 MiB or a case
// that differs after saving and reopening; prints how long the window's event handlers took. xvfb-run -a -s "-screen 0
// 1920x1200x24" random_session [actions=5000] [seed=1] [file…]
#include "app/files/sample_case.h"
#include "tests/app/session/random_user.h"
#include "tests/app/session/session_check.h"
#include "tests/benchmark/timed_application.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"

#include <malloc.h>
#include <QElapsedTimer>
#include <QFile>
#include <QSaveFile>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

using namespace angiopose;

namespace {

constexpr double leakLimitMiB = 20.0;

/// Processor time of all threads since the start of the program, ms.
double processMs()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double heapMiB()
{
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / (1024.0 * 1024.0);
}

/// Backs up and restores the case files. The random user saves over them, for instance with a subtracted run, which
/// takes more memory.
class FilesAsFound {
public:
    explicit FilesAsFound(const QStringList& paths)
    {
        for (const QString& path : paths) {
            QFile file(path);
            if (path.endsWith(QLatin1String(".angiopose")) && file.open(QIODevice::ReadOnly)) {
                contents_.emplace_back(path, file.readAll());
            }
        }
    }

    void putBack() const
    {
        for (const auto& [path, content] : contents_) {
            QSaveFile file(path);
            if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit()) {
                std::fprintf(stderr, "%s could not be put back.\n", qPrintable(path));
            }
        }
    }

private:
    std::vector<std::pair<QString, QByteArray>> contents_;
};

/// Detects data of the open case that are still in memory after it was closed.
class Remains {
public:
    explicit Remains(const core::Case& current)
        : tree_(current.vessels.tree), angiogram_(current.shown().angiogram), stored_(current.shown().storedRun)
    {
    }

    bool areNone() const { return tree_.expired() && angiogram_.expired() && stored_.expired(); }
    /// Prints the reference counts of the vessels, the run as shown and the run as stored.
    void print() const
    {
        std::printf("vessels %ld, shown run %ld, stored run %ld x KEPT", tree_.use_count(), angiogram_.use_count(),
                    stored_.use_count());
    }

private:
    std::weak_ptr<const core::VesselTree> tree_;
    std::weak_ptr<const core::Angiogram> angiogram_;
    std::weak_ptr<const core::Angiogram> stored_;
};

/// Restores the layout, because images are as large as the views that show them. Makes the 3-D view large and small
/// again first: releasing large buffers fills others of the software OpenGL, 8 MiB at least.
void layOutAfresh(ui::MainWindow& window)
{
    constexpr int untilAtRestMs = 1500;
    window.actions()[ui::Command::CornerOnly]->setChecked(true);
    QTest::qWait(untilAtRestMs);
    for (const ui::Command alone : {ui::Command::ImageOnly, ui::Command::CornerOnly, ui::Command::SlicesLarge}) {
        window.actions()[alone]->setChecked(false);
    }
    window.actions()[ui::Command::ResetLayout]->trigger();
    QTest::qWait(untilAtRestMs);
}

/// Opens the files as a new case, to make the memory before and after comparable.
bool openAfresh(app::CaseController& controller, const QStringList& paths)
{
    controller.document().replace({}, {});
    controller.open(paths);
    const bool isOpen = QTest::qWaitFor([&] { return !controller.isLoading() && controller.evaluation(); }, 60000);
    QTest::qWait(1000);
    return isOpen && QTest::qWaitFor([] { return QThreadPool::globalInstance()->activeThreadCount() == 0; }, 60000);
}

QStringList filesOrSample(const QStringList& named)
{
    if (!named.isEmpty()) {
        return named;
    }
    const auto sample = app::writeSampleCase();
    return sample ? QStringList{sample.value()} : QStringList{};
}

/// Opens the first case. Prints the time from the start of the program until the window is shown, and from opening the
/// case until it is drawn and assessed.
bool openFirst(app::WindowHost& host, const QElapsedTimer& sinceStart, QStringList& paths)
{
    const bool isShown = QTest::qWaitForWindowExposed(&host.window());
    std::printf("window shown after %lld ms (aim 1500), processor %.0f ms\n",
                static_cast<long long>(sinceStart.elapsed()), processMs());
    const double processorBefore = processMs();
    QElapsedTimer opening;
    opening.start();
    paths = filesOrSample(paths);
    app::CaseController& controller = host.controller();
    controller.open(paths);
    const bool isOpen = QTest::qWaitFor(
        [&] { return host.window().angiogramView().renderCount() > 0 && controller.evaluation() != nullptr; }, 60000);
    std::printf("case on screen after %lld ms (aim 3000), processor %.0f ms\n",
                static_cast<long long>(opening.elapsed()), processMs() - processorBefore);
    return isShown && isOpen;
}

int run(benchmarks::TimedApplication& application, const QElapsedTimer& sinceStart, int actions, std::uint64_t seed,
        QStringList paths)
{
    app::WindowHost host;
    host.window().resize(1400, 900);
    if (!openFirst(host, sinceStart, paths)) {
        std::fputs("The case did not open.\n", stderr);
        return 1;
    }
    const FilesAsFound found(paths);
    test::RandomUser user(host, seed);
    const auto act = [&](int count) {
        for (int i = 0; i < count; ++i) {
            user.act();
        }
    };
    act(std::min(300, actions / 5));   // fonts, caches and dialogs are created once
    const bool isAtRest = user.comeToRest();
    found.putBack();
    layOutAfresh(host.window());
    if (!isAtRest || !openAfresh(host.controller(), paths)) {
        std::fputs("The window did not come to rest.\n", stderr);
        return 1;
    }
    const double before = heapMiB();

    QElapsedTimer timer;
    timer.start();
    application.isWatching = true;
    act(actions);
    application.isWatching = false;
    const double minutes = static_cast<double>(timer.elapsed()) / 60000.0;

    const QTemporaryDir folder;
    const QString difference = user.comeToRest() ? test::differenceAfterReopening(host.controller(), folder.path())
                                                 : QStringLiteral("something that does not end");
    const Remains closed(host.controller().document().current());
    found.putBack();
    layOutAfresh(host.window());
    openAfresh(host.controller(), paths);
    const double grownMiB = heapMiB() - before;

    std::printf("%d actions in %.1f min, seed %llu, %d events\n", actions, minutes,
                static_cast<unsigned long long>(seed), application.handled);
    std::printf("memory: %+.1f MiB (limit %.0f), of the closed case ", grownMiB, leakLimitMiB);
    closed.areNone() ? static_cast<void>(std::printf("nothing is kept")) : closed.print();
    std::puts("");
    std::printf("after saving and reopening: %s\n", difference.isEmpty() ? "the same" : qPrintable(difference));
    application.printSlow();
    return difference.isEmpty() && grownMiB < leakLimitMiB && closed.areNone() ? 0 : 1;
}

}   // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    qputenv("XDG_CACHE_HOME", home.path().toUtf8());
    QElapsedTimer sinceStart;
    sinceStart.start();
    benchmarks::TimedApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPoseSession"));
    QApplication::setQuitOnLastWindowClosed(false);
    ui::applyTheme(application, ui::ThemeMode::Dark);
    QStringList words = QApplication::arguments().mid(1);
    const int actions = words.isEmpty() ? 5000 : words.takeFirst().toInt();
    const std::uint64_t seed = words.isEmpty() ? 1 : words.takeFirst().toULongLong();
    const int outcome = run(application, sinceStart, actions, seed, words);
    QThreadPool::globalInstance()->waitForDone();
    return outcome;
}
