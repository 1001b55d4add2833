// A case file in, pose and result.json out: what `angiopose-cli register` does.
#include <angiopose/angiopose.h>

#include <iostream>

int main(int count, char** arguments)
try {
    if (count != 3) {
        std::cerr << "usage: register_case CASE.angiopose RESULT.json\n";
        return 2;
    }
    angiopose::Case session = angiopose::readCase(arguments[1]);
    for (const angiopose::Message& warning : session.warnings()) {
        std::cerr << warning.text << "\n";
    }
    const angiopose::RegistrationResult result =
        angiopose::registerCase(session, [](const angiopose::Progress& progress) {
            std::cerr << "\r" << progress.stage << " " << static_cast<int>(100 * progress.fraction) << " %   ";
            return angiopose::Verdict::Continue;
        });
    std::cout << "\n" << result.cameraFromPatient << "\nmedian " << result.metrics.medianPx << " px\n";
    for (const angiopose::Message& warning : result.warnings) {
        std::cout << warning.text << "\n";
    }
    angiopose::writeResult(session, arguments[2]);
    return result.trustworthy ? 0 : 4;
} catch (const angiopose::Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
}
