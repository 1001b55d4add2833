#include "core/case/case_patients.h"
#include "core/simulation/simulated_case.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/results/result_file.h"
#include "io/vessel_tree_file.h"
#include "tests/app/open_window.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/support/forked_vessel.h"

#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

enum class Trait { Number, Name, BirthDate, Sex, Side };

enum class WayIn { AddedView, ReplacedRun, ScanAsVessels, ScanBeside, ScanAndRunTogether, CaseFile };

core::StudyIdentity patient()
{
    core::StudyIdentity identity;
    identity.patientName = "Doe^Jane";
    identity.patientId = "0815";
    identity.birthDate = "1950-01-02";
    identity.sex = "F";
    identity.laterality = "L";
    return identity;
}

core::StudyIdentity anotherIn(Trait trait)
{
    core::StudyIdentity other = patient();
    switch (trait) {
        case Trait::Number:
            other.patientId = "4711";
            break;
        case Trait::Name:
            other.patientName = "Roe^Jane";
            break;
        case Trait::BirthDate:
            other.birthDate = "1950-02-01";
            break;
        case Trait::Sex:
            other.sex = "M";
            break;
        case Trait::Side:
            other.laterality = "R";
            break;
    }
    return other;
}

class Study {
public:
    explicit Study(Trait trait)
    {
        writeRun("run.dcm", patient());
        writeRun("other.dcm", anotherIn(trait));
        writeScan(scan_, patient());
        writeScan(otherScan_, anotherIn(trait));
        EXPECT_TRUE(io::writeVesselTree(simulated_.tree, file("tree.vtp").toStdString()));
        saveCase("one.angiopose", {});
        core::View second;
        second.imageFile.path = file("other.dcm").toStdString();
        saveCase("mixed.angiopose", second);
    }

    QString file(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
    QString scan() const { return QString::fromStdString(scan_.file("")); }
    QString otherScan() const { return QString::fromStdString(otherScan_.file("")); }

private:
    void writeRun(const char* name, const core::StudyIdentity& identity) const
    {
        core::Angiogram run = simulated_.angiogram;
        run.identity = identity;
        EXPECT_TRUE(io::writeAngiogram(run, file(name).toStdString()));
    }

    static void writeScan(const test::TemporaryFolder& folder, const core::StudyIdentity& identity)
    {
        std::vector<test::CtSlice> slices = test::allSlices(test::forkScan());
        for (test::CtSlice& slice : slices) {
            slice.patientName = identity.patientName;
            slice.patientId = identity.patientId;
            slice.birthDate = identity.birthDate;
            std::erase(slice.birthDate, '-');
            slice.sex = identity.sex;
            slice.laterality = identity.laterality;
        }
        test::writeShuffled(folder, slices);
    }

    void saveCase(const char* name, const core::View& second) const
    {
        core::Case session;
        session.vessels.file.path = file("tree.vtp").toStdString();
        session.vessels.tree = std::make_shared<core::VesselTree>(simulated_.tree);
        core::View& view = session.shown();
        view.imageFile.path = file("run.dcm").toStdString();
        view.geometry.cArm = simulated_.angiogram.cArm;
        view.cameraFromPatient = simulated_.initialCameraFromPatient;
        if (!second.imageFile.path.empty()) {
            core::View beside = second;
            beside.geometry = view.geometry;
            beside.cameraFromPatient = view.cameraFromPatient;
            session.views.push_back(std::move(beside));
        }
        EXPECT_TRUE(io::saveCase(session, file(name).toStdString()));
    }

    QTemporaryDir folder_;
    test::TemporaryFolder scan_, otherScan_;
    core::SimulatedCase simulated_ = core::simulateCase(3);
};

void answer(OpenWindow& w, const char* question, const QString& verb)
{
    const auto questions = w.dialogs(question);
    ASSERT_EQ(questions.size(), 1) << question;
    OpenWindow::clickButton(questions.front(), verb);
    EXPECT_TRUE(test::waitFor([&w] { return !w.controller.isLoading(); }));
    if (w.dialogs("patientQuestion").empty()) {
        w.window.activateWindow();   // no window manager does it here
        EXPECT_TRUE(QTest::qWaitForWindowActive(&w.window));
    }
}

void bringIn(OpenWindow& w, const Study& study, WayIn way)
{
    switch (way) {
        case WayIn::AddedView:
            w.drop({study.file("one.angiopose")});
            w.drop({study.file("other.dcm")});
            answer(w, "viewQuestion", QStringLiteral("Add as a view"));
            break;
        case WayIn::ReplacedRun:
            w.drop({study.scan()});
            w.drop({study.file("run.dcm")});
            w.drop({study.file("other.dcm")});
            answer(w, "viewQuestion", QStringLiteral("Replace the angiogram"));
            break;
        case WayIn::ScanAsVessels:
            w.drop({study.file("one.angiopose")});
            w.drop({study.otherScan()});
            answer(w, "scanQuestion", QStringLiteral("Trace this scan"));
            break;
        case WayIn::ScanBeside:
            w.drop({study.file("one.angiopose")});
            w.drop({study.otherScan()});
            answer(w, "scanQuestion", QStringLiteral("Show with the vessels"));
            break;
        case WayIn::ScanAndRunTogether:
            w.drop({study.scan(), study.file("other.dcm")});
            break;
        case WayIn::CaseFile:
            w.drop({study.file("mixed.angiopose")});
            break;
    }
}

class AnotherPatient : public ::testing::TestWithParam<Trait> {};

TEST_P(AnotherPatient, IsAskedAboutHoweverTheFilesComeIn)
{
    const Study study(GetParam());
    for (const WayIn way : {WayIn::AddedView, WayIn::ReplacedRun, WayIn::ScanAsVessels, WayIn::ScanBeside,
                            WayIn::ScanAndRunTogether, WayIn::CaseFile}) {
        SCOPED_TRACE(static_cast<int>(way));
        OpenWindow w;
        bringIn(w, study, way);
        ASSERT_EQ(w.dialogs("patientQuestion").size(), 1);
        EXPECT_TRUE(core::findMismatch(w.current()).empty());   // nothing has come in unasked
        answer(w, "patientQuestion", QStringLiteral("Do not open"));
        EXPECT_TRUE(core::findMismatch(w.current()).empty());

        OpenWindow agreed;
        bringIn(agreed, study, way);
        answer(agreed, "patientQuestion", QStringLiteral("Open anyway"));
        EXPECT_FALSE(core::findMismatch(agreed.current()).empty());
        EXPECT_FALSE(agreed.current().shown().isSamePatient);
    }
}

TEST(WindowPatient, WhoIsTheSameByTheUsersWordIsToldAndTrusted)
{
    const Study study(Trait::Number);
    OpenWindow w;
    bringIn(w, study, WayIn::CaseFile);
    answer(w, "patientQuestion", QStringLiteral("Open as same patient"));
    EXPECT_FALSE(core::findMismatch(w.current()).empty());
    EXPECT_TRUE(std::ranges::all_of(w.current().views, &core::View::isSamePatient));
    w.drop({study.file("other.dcm")});
    answer(w, "viewQuestion", QStringLiteral("Add as a view"));
    answer(w, "patientQuestion", QStringLiteral("Open anyway"));
    EXPECT_TRUE(std::ranges::none_of(w.current().views, &core::View::isSamePatient)) << "the last answer counts";
}

INSTANTIATE_TEST_SUITE_P(Traits, AnotherPatient,
                         ::testing::Values(Trait::Number, Trait::Name, Trait::BirthDate, Trait::Sex, Trait::Side));

TEST(WindowPatient, TheSamePatientIsNotAskedAbout)
{
    const Study study(Trait::Number);
    OpenWindow w;
    w.drop({study.file("one.angiopose")});
    w.drop({study.scan()});
    answer(w, "scanQuestion", QStringLiteral("Show with the vessels"));
    EXPECT_TRUE(w.dialogs("patientQuestion").empty());
    EXPECT_TRUE(w.current().vessels.scan);
}

QString barOf(OpenWindow& w)
{
    QStringList words;
    for (const QLabel* label : w.window.patient().findChildren<QLabel*>()) {
        if (label->isVisible()) {
            words << label->text();
        }
    }
    return words.join(u' ');
}

TEST(WindowPatient, StandsOverTheCaseUntilOneKeyHidesWhoItIs)
{
    const Study study(Trait::Number);
    OpenWindow w;
    EXPECT_FALSE(w.window.patient().isVisible());
    w.drop({study.file("one.angiopose")});
    EXPECT_EQ(barOf(w), QStringLiteral("Doe Jane ID 0815 · born 1950-01-02 · F (angiogram)"));
    w.drop({study.scan()});
    answer(w, "scanQuestion", QStringLiteral("Show with the vessels"));
    EXPECT_TRUE(barOf(w).endsWith(QStringLiteral("(scan, angiogram)"))) << barOf(w).toStdString();

    w.press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(barOf(w).contains(QStringLiteral("hidden"))) << barOf(w).toStdString();
    EXPECT_FALSE(barOf(w).contains(QStringLiteral("Doe")) || barOf(w).contains(QStringLiteral("0815")));
    w.press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(barOf(w).contains(QStringLiteral("Doe Jane")));

    w.drop({study.file("other.dcm")});
    answer(w, "viewQuestion", QStringLiteral("Add as a view"));
    answer(w, "patientQuestion", QStringLiteral("Open anyway"));
    EXPECT_TRUE(barOf(w).startsWith(QStringLiteral("The inputs belong to different patients")))
        << barOf(w).toStdString();
    EXPECT_TRUE(barOf(w).contains(QStringLiteral("ID 0815")) && barOf(w).contains(QStringLiteral("ID 4711")));
    EXPECT_TRUE(barOf(w).contains(QStringLiteral("(scan, view 1)")) && barOf(w).contains(QStringLiteral("(view 2)")));
    w.press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(barOf(w).startsWith(QStringLiteral("The inputs belong to different patients")));
    EXPECT_FALSE(barOf(w).contains(QStringLiteral("4711")));
    w.press(Qt::Key_P, Qt::ShiftModifier);
}

TEST(WindowPatient, AViewOfAnotherExaminationIsAskedAbout)
{
    const Study study(Trait::Number);
    core::Angiogram run = io::readAngiogram(study.file("run.dcm").toStdString()).value();
    run.identity.accessionNumber = "A1";
    ASSERT_TRUE(io::writeAngiogram(run, study.file("run.dcm").toStdString()));
    run.identity.accessionNumber = "A2";
    ASSERT_TRUE(io::writeAngiogram(run, study.file("later.dcm").toStdString()));
    OpenWindow w;
    w.drop({study.file("one.angiopose")});
    w.drop({study.file("later.dcm")});
    answer(w, "viewQuestion", QStringLiteral("Add as a view"));
    answer(w, "patientQuestion", QStringLiteral("Open anyway"));
    EXPECT_TRUE(barOf(w).startsWith(QStringLiteral("The inputs do not match"))) << barOf(w).toStdString();
}

TEST(WindowPatient, WhatIsExportedSaysThatPatientsAreMixed)
{
    const Study study(Trait::Number);
    OpenWindow w;
    w.drop({study.file("mixed.angiopose")});
    answer(w, "patientQuestion", QStringLiteral("Open anyway"));
    w.waitForJudgement();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("overlay.png"));
    QSignalSpy exported(&w.controller.exportController(), &ExportController::exported);
    w.controller.exportController().exportOverlay({600, ui::Toggle::Off, ui::Toggle::Off}, path);
    ASSERT_TRUE(exported.wait(test::patienceMs));
    EXPECT_TRUE(QImage(path).text(QStringLiteral("Patient")).contains(QStringLiteral("different patients")));

    core::Case judged = w.current();
    EXPECT_NE(io::resultJson(judged, {}).find("different patients"), std::string::npos);
}

}   // namespace
}   // namespace angiopose::app
