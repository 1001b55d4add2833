#include "tests/benchmark/foreign/answer.h"

#include "core/registration/registration.h"

#include <cstdio>

namespace angiopose::benchmarks {

ForeignAnswer ask(const ForeignCase& asked)
{
    const auto result = core::registerVessels(asked.input, {});
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message.text().c_str());
        return {{1e9, 1e9, 180.0}, false, 0.0};
    }
    return {errorOf(asked, result.value().cameraFromPatient), result.value().trustworthy, result.value().time.totalMs};
}

}   // namespace angiopose::benchmarks
