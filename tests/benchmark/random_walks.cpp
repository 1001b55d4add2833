// Random walks through cases (issue 18): each case is opened, worked on at random, registered, saved and reopened, and
// every step undone and redone; prints the differences between before and after. A walk takes 10 to 20 s, forty take
// about 10 minutes. xvfb-run -a -s "-screen 0 1920x1200x24" random_walks [--walks 40] [--seed 1] [--actions 20] [--keep
// DIR] [--tell] [case…]
#include "app/files/sample_case.h"
#include "tests/app/session/random_walk.h"
#include "ui/theme/active_theme.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QThreadPool>

#include <cstdio>

using namespace angiopose;

namespace {

struct Plan {
    int walks = 40;
    std::uint64_t seed = 1;
    int actions = 20;
    QString folder;
    QStringList cases;
    bool isKnown = false;
};

Plan planOf(const QStringList& arguments, const QString& folder)
{
    QCommandLineParser parser;
    const QCommandLineOption walks(QStringLiteral("walks"), {}, QStringLiteral("n"), QStringLiteral("40"));
    const QCommandLineOption seed(QStringLiteral("seed"), {}, QStringLiteral("n"), QStringLiteral("1"));
    const QCommandLineOption actions(QStringLiteral("actions"), {}, QStringLiteral("n"), QStringLiteral("20"));
    const QCommandLineOption keep(QStringLiteral("keep"), QStringLiteral("Folder for what the walks write."),
                                  QStringLiteral("dir"), folder);
    const QCommandLineOption tell(QStringLiteral("tell"), QStringLiteral("Prints every action."));
    parser.addOptions({walks, seed, actions, keep, tell});
    parser.addHelpOption();
    parser.addPositionalArgument(QStringLiteral("case"), QStringLiteral("Taken in turns; absent: the sample."));
    parser.process(arguments);
    return {parser.value(walks).toInt(), parser.value(seed).toULongLong(), parser.value(actions).toInt(),
            parser.value(keep),          parser.positionalArguments(),     parser.isSet(tell)};
}

/// Returns true if there was no difference.
bool walk(const Plan& plan, int number)
{
    const std::uint64_t seed = plan.seed + static_cast<std::uint64_t>(number);
    const QString& opened = plan.cases[number % plan.cases.size()];
    QElapsedTimer timer;
    timer.start();
    test::RandomWalk planned{{opened}, seed, plan.actions, plan.folder + QStringLiteral("/%1").arg(seed)};
    if (plan.isKnown) {
        planned.reported = [](const QString& action) { std::printf("    %s\n", qPrintable(action)); };
    }
    const QStringList surprises = test::surprisesOf(planned);
    std::printf("seed %llu: %s (%.0f s)\n", static_cast<unsigned long long>(seed),
                surprises.isEmpty() ? "identical" : "DIFFERENT", static_cast<double>(timer.elapsed()) / 1000.0);
    for (const QString& surprise : surprises) {
        std::printf("  %s\n", qPrintable(surprise));
    }
    std::fflush(stdout);
    return surprises.isEmpty();
}

}   // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    qputenv("XDG_CACHE_HOME", home.path().toUtf8());
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPoseWalks"));
    QApplication::setQuitOnLastWindowClosed(false);
    ui::applyTheme(application, ui::ThemeMode::Dark);
    ui::applyLanguage(QStringLiteral("en"));
    Plan plan = planOf(QApplication::arguments(), home.path());
    if (plan.cases.isEmpty()) {
        const auto sample = app::writeSampleCase();
        plan.cases = sample ? QStringList{sample.value()} : QStringList{};
    }
    if (plan.cases.isEmpty()) {
        std::fputs("The sample case could not be written.\n", stderr);
        return 1;
    }
    QElapsedTimer timer;
    timer.start();
    int identical = 0;
    for (int number = 0; number < plan.walks; ++number) {
        identical += walk(plan, number) ? 1 : 0;
    }
    std::printf(
        "%d of %d walks identical in %.1f min: case, words and pictures of panels and image, overlay, report and "
        "result before and after saving and reopening; case and words of the result after undoing to the start; "
        "case after doing all again\n",
        identical, plan.walks, static_cast<double>(timer.elapsed()) / 60000.0);
    QThreadPool::globalInstance()->waitForDone();
    return identical == plan.walks ? 0 : 1;
}
